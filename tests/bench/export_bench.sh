#!/usr/bin/env bash
# All targets of a set in one run against what that costs at least, in CPU time of all processes: each distinct picture encoded once with
# OpenImageIO (also those inside .glb and .html files), and the maps baked. Usage:
# export_bench.sh FOLDER-OF-PROGRAMS [SET [TECHNIQUE]]; without SET a built-in one of 2048 x 2048 and 16 bits.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
bin=${1:?the folder of the programs}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export RELIEVO_CACHE=off
technique=${3:-relief}
median() { sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }
cpu() { ( TIMEFORMAT='%U %S'; { time "$@" >/dev/null 2>&1; } 2>&1 ) | awk '{print int(($1 + $2) * 1000)}'; }

set=${2:-$work/set}
[ $# -gt 1 ] || "$bin/relievo" export sample:bricks@2048 --target textures -o "$set" --quiet
targets=$("$bin/relievo" describe exports --json | python3 -c 'import json, sys; print(",".join(e["key"] for e in json.load(sys.stdin)["exports"]))')
"$bin/relievo" export "$set" --technique "$technique" --target "$targets" -o "$work/all" --quiet

# Every picture once, by its bytes.
python3 - "$work/all" "$work/pictures" <<'PY'
import base64, hashlib, os, re, sys
out, seen = sys.argv[2], set()
os.makedirs(out)
def keep(data, suffix):
    name = hashlib.sha256(data).hexdigest()
    if name not in seen:
        seen.add(name)
        open(f"{out}/{name}{suffix}", "wb").write(data)
for folder, _, names in os.walk(sys.argv[1]):
    for name in names:
        data, suffix = open(f"{folder}/{name}", "rb").read(), os.path.splitext(name)[1]
        if suffix in (".png", ".jpg", ".exr", ".tif", ".tga"):
            keep(data, suffix)
        elif suffix == ".glb":
            for start in (m.start() for m in re.finditer(rb"\x89PNG\r\n\x1a\n", data)):
                keep(data[start:data.index(b"IEND\xaeB`\x82", start) + 8], ".png")
        elif suffix == ".html":
            for text in re.findall(rb'"(iVBORw0KGgo[A-Za-z0-9+/=]+)"', data):
                keep(base64.b64decode(text), ".png")
PY

techniques() { "$bin/relievo" describe techniques --json | python3 -c "import json, sys; all = json.load(sys.stdin)['techniques']; print($1)"; }
bound=$(techniques "next(t['bound'] for t in all if t['key'] == '$technique')")
maps=$(printf 'cell-cone\n%s\n' "$bound" | sort -u | sed '/^$/d') # the page's second picture is by cell cones
# What baking adds to a picture that is drawn by each map: without and with it in the cache.
baking() {
    local sum=0 map technique cold warm
    for map in $maps; do
        technique=$(techniques "next(t['key'] for t in all if t['bound'] == '$map')")
        rm -rf "$work/cache"
        draw() { RELIEVO_CACHE=$work/cache cpu "$bin/relievo" render "$set" --technique "$technique" --set heightMips=false --size 16x16 -o "$work/x.png"; }
        cold=$(draw) warm=$(draw)
        sum=$((sum + cold - warm))
    done
    echo "$sum"
}

all='' encoded='' decoded='' baked=''
for i in 1 2 3; do
    all+="$(cpu "$bin/relievo" export "$set" --technique "$technique" --target "$targets" -o "$work/all")"$'\n'
    encoded+="$("$bin/encode_images" "$work"/pictures/*)"$'\n'
    decoded+="$(cpu "$bin/read_images" $(find "$set" -maxdepth 1 -type f ! -name '*.json'))"$'\n'
    baked+="$(baking)"$'\n'
done
a=$(printf '%s' "$all" | median) e=$(printf '%s' "$encoded" | median) d=$(printf '%s' "$decoded" | median) b=$(printf '%s' "$baked" | median)
echo "$technique, CPU ms: all targets $a; $(find "$work/pictures" -type f | wc -l) pictures encoded once $e, maps baked $b, set decoded $d"
awk -v a="$a" -v e="$e" -v b="$b" -v d="$d" 'BEGIN {
    printf "all targets / (encoded + baked) = %.2f, / (encoded + baked + decoded) = %.2f\n", a / (e + b), a / (e + b + d)}'
