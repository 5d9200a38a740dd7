#!/usr/bin/env bash
# Runs every reader of our exports, one after another, and prints a table: all.sh RELIEVO BUILD DATA [NAME...].
# BUILD/clients/log keeps what each said. Fails when one does; what cannot be installed is skipped.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3
shift 3
export RELIEVO_IMAGEIO=${RELIEVO_IMAGEIO:-$(dirname "$relievo")/relievo-imageio} RELIEVO_CACHE=${RELIEVO_CACHE:-off}
log=$build/clients/log
mkdir -p "$log"
# Script, what it checks, and the pattern of the lines that tell a version.
rows=(
  "gltf_validator|glTF: no error|^gltf-validator "
  "text|texts parse, names are the engines', shaders of each technique compile|^(tinyusdz|glslangValidator) "
  "materialx|reads, validates, generates ESSL|^MaterialX "
  "godot4|properties read back, shaders compile, UVs at 45 and 70 degrees, with tiling|^Godot "
  "godot3|imports, properties read back|^Godot "
  "web|modules run without a message, UVs at 45 and 70 degrees, displacement|^(babylon|playcanvas|three) "
  "web_page|opens from disk without a message, pictures agree with render|^Chromium "
  "blender|lists the glTF material, runs the script, displaces by the promised depth|^Blender [0-9.]+:"
  "engines|techniques that draw as engines do, against the engines|^Godot |^(babylon|playcanvas) "
  "recipes|the manual's lines for GNU parallel and Slurm, run as they stand|^(GNU parallel|Slurm) "
)
failed=0
table=()
for row in "${rows[@]}"; do
  IFS='|' read -r name checked version <<<"$row"
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then
    continue
  fi
  echo "== $name"
  third=$data
  [ "$name" != web_page ] || third=$(dirname "$relievo")/flip # compares its pictures
  "$here/$name.sh" "$relievo" "$build" "$third" 2>&1 | tee "$log/$name.txt"
  case ${PIPESTATUS[0]} in
    0) result=right ;;
    77) result=skipped ;;
    *) result=WRONG failed=1 ;;
  esac
  reader=$(grep -E "$version" "$log/$name.txt" | sed -E 's/[:,].*//; s/ all depths.*//' | sort -u | paste -sd, | sed 's/,/, /g')
  table+=("| $name | ${reader:--} | $checked | $result |")
done
printf '\n| script | reader | checked | result |\n|---|---|---|---|\n'
printf '%s\n' "${table[@]}"
exit $failed
