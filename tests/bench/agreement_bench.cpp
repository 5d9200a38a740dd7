// The GPU's answers beside the CPU's, of the same search text: 10,000 rays of each SET and technique, in both dialects.
// Usage: agreement_bench SET...
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/state/techniques.h"
#include "tests/core/image/source_support.h"
#include "tests/render/agreement.h"
#include <algorithm>
#include <cstdio>

using namespace relievo;

int main(int count, char** arguments)
{
    const auto context = WindowlessContext::create();
    if (!context)
        return std::fprintf(stderr, "%s\n", message(context.error()).c_str()), 1;
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const auto rays = test::raysOf(10000, 21);
    for (int i = 1; i < count; ++i) {
        const auto heights = test::heightsOf(arguments[i]);
        if (!heights)
            return std::fprintf(stderr, "%s\n", message(heights.error()).c_str()), 1;
        test::Agreement worst;
        for (const TechniqueRow& row : kTechniques) {
            if (row.file.empty())
                continue;
            const auto cpu = traceRays(row.key, Parameters(), &*heights, rays);
            if (!cpu)
                return std::fprintf(stderr, "%s\n", message(cpu.error()).c_str()), 1;
            for (const Dialect dialect : {Dialect::Desktop, Dialect::Es}) {
                const auto found = test::agreement(*cpu, row.key, *heights, rays, dialect);
                if (!found)
                    return std::fprintf(stderr, "%s\n", message(found.error()).c_str()), 1;
                if (found->apart + found->otherFetches > 0)
                    std::printf("    %-13s %-7s t apart %.2f %%, other fetch counts %.2f %%\n", std::string(row.key).c_str(),
                        dialect == Dialect::Es ? "ES 3.00" : "4.5", 1e-2 * found->apart, 1e-2 * found->otherFetches);
                worst.apart = std::max(worst.apart, found->apart);
                worst.otherFetches = std::max(worst.otherFetches, found->otherFetches);
            }
        }
        std::printf("%s, %d x %d: at worst t apart %.2f %%, other fetch counts %.2f %%\n", arguments[i], heights->width(),
            heights->height(), 1e-2 * worst.apart, 1e-2 * worst.otherFetches);
    }
}
