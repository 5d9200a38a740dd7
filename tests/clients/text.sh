#!/usr/bin/env bash
# Every target by text is read by a parser of its format, and holds the names that its engine knows: text.sh RELIEVO BUILD DATA.
# Python, YAML, JSON and XML by Python's parsers, modules by node, USD by the package tinyusdz, GLSL and HLSL of each technique by
# glslangValidator, and by spirv-val what it makes of them; Unreal's script runs against the nodes and pins that it may name. Exits 77 (skipped) when a reader is not there and cannot be installed.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3 out=$2/clients/text
. "$here/exports/tools.sh"
needs glslangValidator spirv-val python:yaml -- glslang-tools spirv-tools python3-yaml
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
# compiles FILE [OPTION...]: tells the first faults.
compiles() {
  local file=$1
  shift
  programs=$((programs + 1))
  if ! glslangValidator "$@" "$file" -o "$out/program.spv" >"$out/glslang.txt" || ! spirv-val "$out/program.spv" >>"$out/glslang.txt" 2>&1; then
    echo "${file#"$out"/}: $(grep -v '^$' "$out/glslang.txt" | head -5)"
    failed=1
  fi
}
# Each technique as it is, and with everything else that a program's text depends on.
plain="" other="--set wrap=clamp --set lightSize=5 --set depthOfHit=true --set edgeFade=0.5 --set shading=blinn-phong --without normals"
for technique in $("$relievo" describe techniques --json | /usr/bin/python3 -c '
import json, sys
print(*(row["key"] for row in json.load(sys.stdin)["techniques"] if row["key"] != "reference"))'); do # the reference has no shader
  for kind in plain other; do
    to=$out/programs/$kind/$technique
    # shellcheck disable=SC2086
    if ! "$relievo" export sample:bricks@64 --target glsl,hlsl,unreal --technique "$technique" --quiet ${!kind} -o "$to" 2>"$out/refused.txt"; then
      echo "$technique: $(cat "$out/refused.txt")"
      failed=1
      continue
    fi
    for program in "$to"/glsl/relief_410.{vert,frag}; do
      compiles "$program" -R -V --aml --amb
    done
    for program in "$to"/glsl/relief_es300.{vert,frag}; do
      programs=$((programs + 1))
      glslangValidator "$program" >"$out/glslang.txt" || { echo "$program: $(grep -v '^$' "$out/glslang.txt" | head -5)"; failed=1; }
    done
    compiles "$to/hlsl/relief.hlsl" -D -V -e main -S frag
    compiles "$to/hlsl/relief_vertex.hlsl" -D -V -e main -S vert
  done
done
/usr/bin/python3 "$here/exports/check_text.py" "$out"/programs/*/*/unreal || failed=1
echo "glslangValidator $(glslangValidator --version | sed -n 's/^Glslang Version: [0-9]*://p'): $programs programs"
exit $failed
