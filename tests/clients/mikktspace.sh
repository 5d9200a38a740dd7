#!/usr/bin/env bash
# Tangents agree with the package mikktspace on shapes and real meshes: mikktspace.sh TANGENT_BENCH BUILD DATA; prints the figures.
# Installs the package into the build folder once; exits 77 (skipped) when that is not possible.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bench=$1 build=$2 data=$3
tools=$build/clients/npm-mikktspace out=$build/clients/tangents
if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
  echo "skipped: npm is not installed"
  exit 77
fi
if [ ! -d "$tools/node_modules/mikktspace" ]; then
  mkdir -p "$tools"
  if ! timeout 90 npm install --prefix "$tools" --no-audit --no-fund --silent mikktspace >"$tools/install.log" 2>&1; then
    echo "skipped: mikktspace could not be installed, see $tools/install.log"
    exit 77
  fi
fi
rm -rf "$out"
mkdir -p "$out"
for mesh in plane sphere cylinder torus box teapot spheres "$data"/meshes/{spot.obj,teapot.obj,Avocado/glTF/Avocado.gltf,NormalTangentMirrorTest.glb,animated/CesiumMan.glb}; do
  name=$(basename "$mesh")
  case $mesh in */*) [ -f "$mesh" ] || { echo "skipped: no $name"; continue; } ;; esac
  "$bench" "$mesh" "$out/$name.corners"
done
NODE_PATH=$tools/node_modules node "$here/mikktspace.js" "$out"/*.corners
