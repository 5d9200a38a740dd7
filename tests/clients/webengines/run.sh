#!/bin/sh
# run.sh ENGINE MATERIAL_FOLDER OUT [--pitch 45,20 --yaw 20 ...]   (--help lists all)
# ENGINE: babylon | playcanvas | three.  See README.md.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cache=${WEBENGINES_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/webengines}
export WEBENGINES_CACHE="$cache" CHROMIUM="${CHROMIUM:-/usr/bin/chromium}"
python=${PYTHON:-/usr/bin/python3}   # needs numpy and PIL

[ -x "$CHROMIUM" ] || { echo "no $CHROMIUM: apt-get install --no-install-recommends chromium" >&2; exit 2; }
for p in babylonjs playcanvas three puppeteer-core; do
	[ -d "$cache/node_modules/$p" ] || missing=1
done
if [ -n "${missing:-}" ]; then
	mkdir -p "$cache"
	(cd "$cache" && { [ -f package.json ] || echo '{"private":true}' > package.json; } &&
	 npm install --ignore-scripts --no-audit --no-fund \
	 babylonjs@9.35.0 playcanvas@2.23.3 three@0.187.0 puppeteer-core@24.43.1) >&2
fi
exec "$python" "$here/webengine.py" "$@"
