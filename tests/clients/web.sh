#!/usr/bin/env bash
# The modules exported for Babylon, PlayCanvas and three run in headless Chromium and draw what was promised: web.sh RELIEVO BUILD DATA [ENGINE...].
# Prints the figures. The engines are npm packages, installed into the build folder once; exits 77 (skipped) when that is not possible.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3 out=$2/clients/web
shift 3
. "$here/exports/tools.sh"
needs chromium python:numpy python:PIL -- chromium python3-numpy python3-pil
export WEBENGINES_CACHE=$build/clients/npm-webengines PYTHONDONTWRITEBYTECODE=1
npm_packages "$WEBENGINES_CACHE" babylonjs@9.35.0 playcanvas@2.23.3 three@0.187.0 puppeteer-core@24.43.1
rm -rf "$out"
"$here/exports/write.sh" "$relievo" "$out/plain" "$data" babylon,playcanvas,three,packed
# Tiles and the rest of the placement, and heights above the mesh; a clamped texture would show its border.
"$here/exports/write.sh" "$relievo" "$out/placed" "$data" babylon,playcanvas,three,packed --set tiling=2 --set offsetU=0.25 --set offsetV=0.125 \
  --set depth=0.08 --set midlevel=0.5
# Other searches of ours: an exact one, and cones.
for technique in cell-cone cone-relaxed; do
  "$relievo" export sample:bricks@256 --target babylon,playcanvas,three,packed --technique $technique --quiet -o "$out/$technique/bricks"
done
failed=0
for engine in "${@:-babylon playcanvas three}"; do
  for one in $engine; do
    /usr/bin/python3 "$here/exports/check_web.py" "$relievo" "$out" "$one" || failed=1
  done
done
exit $failed
