#!/usr/bin/env bash
# Every target by text is read by a parser of its format, and holds the names that its engine knows: text.sh RELIEVO BUILD DATA.
# Python, YAML, JSON and XML by Python's parsers, modules by node, USD by the package tinyusdz, GLSL of each technique by glslangValidator;
# Unreal's script runs against the nodes and pins that it may name. Exits 77 (skipped) when a reader is not there and cannot be installed.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3 out=$2/clients/text
. "$here/exports/tools.sh"
needs glslangValidator python:yaml -- glslang-tools python3-yaml
npm_packages "$build/clients/npm-usd" tinyusdz@0.9.0-rc10
targets=$("$relievo" describe exports --json | /usr/bin/python3 -c '
import json, sys
print(",".join(row["key"] for row in json.load(sys.stdin)["exports"] if row["suffix"] == "folder"))')
"$here/exports/write.sh" "$relievo" "$out/sets" "$data" "$targets"
"$here/exports/write.sh" "$relievo" "$out/placed" "$data" "$targets" --set tiling=2 --set offsetU=0.25 --set offsetV=0.125 --set depth=0.08
failed=0
/usr/bin/python3 "$here/exports/check_text.py" "$out/sets" "$out/placed" || failed=1
find "$out/sets" "$out/placed" -name '*.usda' -print0 | xargs -0 node "$here/exports/read_usd.mjs" "$build/clients/npm-usd" || failed=1

programs=0
for technique in $("$relievo" describe techniques --json | /usr/bin/python3 -c '
import json, sys
print(*(row["key"] for row in json.load(sys.stdin)["techniques"] if row["key"] != "reference"))'); do # the reference has no shader
  if ! "$relievo" export sample:bricks@64 --target glsl --technique "$technique" --quiet -o "$out/glsl/$technique" 2>"$out/refused.txt"; then
    echo "glsl $technique: $(cat "$out/refused.txt")"
    failed=1
    continue
  fi
  for program in "$out/glsl/$technique"/relief_*.{vert,frag}; do
    programs=$((programs + 1))
    if ! glslangValidator "$program" >"$out/glslang.txt"; then
      echo "glsl $technique: $(grep -v '^$' "$out/glslang.txt" | head -5)"
      failed=1
    fi
  done
done
echo "glslangValidator $(glslangValidator --version | sed -n 's/^Glslang Version: [0-9]*://p'): $programs programs"
exit $failed
