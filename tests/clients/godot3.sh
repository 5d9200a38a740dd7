#!/usr/bin/env bash
# Godot 3 imports what is exported for it and reads every property back: godot3.sh RELIEVO BUILD DATA.
# Runs Debian's godot3 under xvfb; exits 77 (skipped) when it is not there and cannot be installed.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
relievo=$1 build=$2 data=$3 out=$2/clients/godot3
. "$here/exports/tools.sh"
needs godot3 xvfb-run -- godot3 xvfb
export XDG_CONFIG_HOME=$out/home XDG_DATA_HOME=$out/home XDG_CACHE_HOME=$out/home
rm -rf "$out"
"$here/exports/write.sh" "$relievo" "$out/project/plain" "$data" godot3
"$here/exports/write.sh" "$relievo" "$out/project/placed" "$data" godot3 --set tiling=2 --set offsetU=0.25 --set depth=0.08 --technique parallax
cp "$here"/godot3/* "$out/project"
mkdir -p "$out/home"
wanted=$(find "$out/project" -name '*.png' | wc -l)
imported() { find "$out/project/.import" -name '*.md5' 2>/dev/null | wc -l; }
# The editor imports the pictures by their .import files, and does not end by itself. It knows no locale C.
timeout 200 xvfb-run -a env -u LC_ALL LANG=en_US.UTF-8 godot3 -e -q --path "$out/project" --video-driver GLES2 --audio-driver Dummy >"$out/import.log" 2>&1 &
editor=$!
while kill -0 $editor 2>/dev/null && [ "$(imported)" -lt "$wanted" ]; do
  sleep 1
done
sleep 2 # the last file is written out
kill $editor 2>/dev/null || true
wait $editor 2>/dev/null || true
if [ "$(imported)" -lt "$wanted" ]; then
  echo "$(imported) of $wanted pictures were imported"
  tail -5 "$out/import.log"
  exit 1
fi
status=0
timeout 100 xvfb-run -a env -u LC_ALL LANG=en_US.UTF-8 godot3 --path "$out/project" -s check.gd --video-driver GLES2 --audio-driver Dummy >"$out/check.log" 2>&1 || status=$?
grep -E '^(FAULT|Godot [0-9])|^(SCRIPT )?ERROR' "$out/check.log" || status=1
grep -qE '^(SCRIPT )?ERROR' "$out/check.log" && status=1
exit $status
