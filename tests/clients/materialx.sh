#!/usr/bin/env bash
# MaterialX itself reads, validates and generates ESSL from each exported .mtlx: materialx.sh RELIEVO BUILD DATA; prints the versions.
# It is MaterialX in WebAssembly, npm's @needle-tools/materialx, installed into the build folder once; exits 77 (skipped) when that is not possible.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3 out=$2/clients/materialx
. "$here/exports/tools.sh"
npm_packages "$build/clients/npm-materialx" @needle-tools/materialx@1.4.6
"$here/exports/write.sh" "$relievo" "$out/sets" "$data" materialx
"$here/exports/write.sh" "$relievo" "$out/placed" "$data" materialx --set tiling=2 --set offsetU=0.25 --set rotation=30 --set wrap=clamp
find "$out" -name '*.mtlx' -print0 | sort -z | xargs -0 node "$here/exports/read_materialx.mjs" "$build/clients/npm-materialx"
