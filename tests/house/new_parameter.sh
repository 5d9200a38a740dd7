#!/usr/bin/env bash
# A parameter is one member and one row: with both it appears in JSON, --set, uniforms and describe (the program given was built with
# a table that has two more lines); one without the other does not compile.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
source=${1:?the source folder} widened=${2:?the header with one parameter more} program=${3:?the program built with it}
compiler=${CXX:-c++} header=$source/core/state/parameters.h
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; head -20 "$work/log" 2>/dev/null; exit 1; }
compiles() { "$compiler" -std=c++20 -fsyntax-only -I"$source" -x c++ - <<< "#include \"$(realpath "$1")\"" 2>"$work/log"; }

[ "$(diff "$header" "$widened" | grep -c '^[<>]')" -eq 2 ] || fail 'the new parameter did not take exactly two places'
grep -v '&Parameters::zebra' "$widened" > "$work/member.h"
compiles "$work/member.h" && fail 'a member without a row compiles'
grep -q 'wants exactly one row' "$work/log" || fail 'the message for a member without a row is unclear'
grep -v 'float zebra' "$widened" > "$work/row.h"
compiles "$work/row.h" && fail 'a row without a member compiles'
compiles "$widened" || fail 'member and row together do not compile'

out=$("$program")
for wanted in 'set 1' 'json 1' 'uniform 1' 'describe 1'; do
    grep -q "$wanted" <<< "$out" || fail "missing: $wanted"
done
