// A program built with one more member and row in the parameter table (zebra): it must turn up everywhere without another line.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/describe_parameters.h"
#include "core/shader_text/program_text.h"
#include "core/state/state_json.h"
#include <algorithm>
#include <cstdio>

int main()
{
    using namespace relievo;
    State state;
    const bool set = bool(setParameter(state, "zebra=0.75"));
    const std::string json = toJson(state, "/");
    const auto read = fromJson(State(), json, "/", "test");
    const auto table = cli::parameterTable();
    const auto isTold = [](const nlohmann::ordered_json& row) { return row["key"] == "zebra" && row["label"] == "Zebra"; };
    std::printf("set %d\n", int(set && state.parameters.zebra == 0.75f));
    std::printf("json %d\n", int(read && read->state == state && json.find("\"zebra\": 0.75") != std::string::npos));
    std::printf("uniform %d\n", int(uniformDeclarations("x = zebra;").find("uniform float zebra;") != std::string::npos));
    std::printf("describe %d\n", int(std::ranges::count_if(table, isTold) == 1));
}
