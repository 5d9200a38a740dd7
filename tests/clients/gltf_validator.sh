#!/usr/bin/env bash
# The Khronos validator must find no error in what `export --target gltf` writes: gltf_validator.sh RELIEVO BUILD DATA.
# Installs the validator into the build folder once; exits 77 (skipped) when that is not possible.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3
tools=$build/clients/npm
if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
  echo "skipped: npm is not installed"
  exit 77
fi
if [ ! -d "$tools/node_modules/gltf-validator" ]; then
  mkdir -p "$tools"
  if ! timeout 90 npm install --prefix "$tools" --no-audit --no-fund --silent gltf-validator >"$tools/install.log" 2>&1; then
    echo "skipped: the validator could not be installed, see $tools/install.log"
    exit 77
  fi
fi
"$here/glb_of_samples.sh" "$relievo" "$build/clients/validated" "$data"
"$relievo" export sample:bricks --target gltf --with bump --size 256 -o "$build/clients/validated/as text.gltf" >/dev/null
NODE_PATH=$tools/node_modules node "$here/gltf_validator.js" "$build"/clients/validated/*.gl*
