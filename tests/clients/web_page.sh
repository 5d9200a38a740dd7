#!/usr/bin/env bash
# Exported web pages in headless Chromium, opened from disk: no console message, and both techniques look as `render` draws them.
# web_page.sh RELIEVO BUILD FLIP; prints the mean FLIP of each picture, of which 0.05 is the most.
# Installs puppeteer-core into the build folder once; exits 77 (skipped) when that or Chromium is missing.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 flip=$3
tools=$build/clients/npm-puppeteer out=$build/clients/web_page
export CHROMIUM=${CHROMIUM:-/usr/bin/chromium}
if ! command -v npm >/dev/null || ! command -v node >/dev/null || [ ! -x "$CHROMIUM" ]; then
  echo "skipped: npm or Chromium is not installed"
  exit 77
fi
if [ ! -d "$tools/node_modules/puppeteer-core" ]; then
  mkdir -p "$tools"
  if ! timeout 120 npm install --prefix "$tools" --ignore-scripts --no-audit --no-fund --silent puppeteer-core@24.43.1 >"$tools/install.log" 2>&1; then
    echo "skipped: puppeteer-core could not be installed, see $tools/install.log"
    exit 77
  fi
fi
rm -rf "$out"
mkdir -p "$out"
side=512
# NAME, the source with what it is drawn by, and the two techniques.
pages=(
  "bricks|sample:bricks@512 --mesh plane|relief cell-cone"
  "cobblestones|sample:cobblestones@512 --mesh sphere --camera yaw=50,pitch=20,fill=0.87 --set background=gradient|cell-cone relief"
  "hammered|sample:hammered@512 --mesh torus --set background=environment --set depthOfHit=true --set midlevel=0.6|parallax cell-cone"
  "planks|sample:planks@512 --mesh box --set tiling=2 --set rotation=30 --set shading=blinn-phong|bump cell-cone"
  "scales|sample:scales@300 --mesh cylinder --set wrap=clamp --set lightSize=8|cone-relaxed cell-cone"
  "terrain|sample:terrain@512 --mesh plane --camera pitch=25|pyramid cell-cone"
)
files=()
for page in "${pages[@]}"; do
  IFS='|' read -r name source techniques <<<"$page"
  "$relievo" export $source --technique "${techniques%% *}" --target web --size 512 --quiet -o "$out/$name.html"
  bytes=$(stat -c %s "$out/$name.html")
  echo "$name.html: $bytes bytes"
  [ "$bytes" -lt 4000000 ]
  files+=("$out/$name.html")
done
NODE_PATH=$tools/node_modules node "$here/web_page.js" "$side" "${files[@]}"
failed=0
for page in "${pages[@]}"; do
  IFS='|' read -r name source techniques <<<"$page"
  for place in a b; do
    technique=$([ "$place" = a ] && echo "${techniques%% *}" || echo "${techniques##* }")
    "$relievo" render $source --technique "$technique" --size "${side}x$side" --quiet -o "$out/${name}_${place}_render.png"
    difference=$("$flip" "$out/${name}_${place}_render.png" "$out/${name}_$place.png")
    echo "$name, $technique: FLIP $difference"
    awk -v d="$difference" 'BEGIN { exit !(d < 0.05) }' || failed=1
  done
done
exit "$failed"
