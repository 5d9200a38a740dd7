#!/usr/bin/env bash
# Blender must list the exported material with its textures, run the exported script, and displace by the promised depth within 2 %:
# blender.sh RELIEVO BUILD DATA; prints the depths. Installs Blender when it may (root).
# Exits 77 (skipped) when Blender is not there and cannot be installed.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3
if ! command -v blender >/dev/null || ! python3 -c 'import numpy' 2>/dev/null; then
  if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null || ! DEBIAN_FRONTEND=noninteractive apt-get install -y -qq blender python3-numpy >/dev/null 2>&1; then
    echo "skipped: blender and python3-numpy are not installed"
    exit 77
  fi
fi
"$here/glb_of_samples.sh" "$relievo" "$build/clients/blender" "$data"
blender -b --factory-startup -noaudio --python-exit-code 3 -P "$here/blender_lists_material.py" -- "$build"/clients/blender/*.glb
"$here/exports/write.sh" "$relievo" "$build/clients/blender_sets" "$data" blender,packed
"$here/exports/write.sh" "$relievo" "$build/clients/blender_placed" "$data" blender,packed --set tiling=2 --set offsetU=0.25 --set depth=0.03 --set midlevel=0.5
scripts=$(find "$build/clients/blender_sets" "$build/clients/blender_placed" -name '*.py' | sort)
# shellcheck disable=SC2086
blender -b --factory-startup -noaudio --python-exit-code 3 -P "$here/exports/blender_displaces.py" -- $scripts 2>&1 | grep -vE '^(Fra:|Saved:| Time:|Blender [0-9.]+$|Read |$)'
