#!/usr/bin/env bash
# Whole processes: the start of `relievo describe`, and `relievo render` of a 2K 16-bit set against OpenImageIO alone on the same files.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
bin=${1:?the folder of the programs}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
median() { sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }
wall() { local s e; s=$(date +%s%N); "$@" >/dev/null 2>&1; e=$(date +%s%N); echo $(((e - s) / 1000000)); }
cpu() { ( TIMEFORMAT='%U %S'; { time "$@" >/dev/null 2>&1; } 2>&1 ) | awk '{print int(($1 + $2) * 1000)}'; }

for i in 1 2 3 4 5 6 7 8 9; do cpu "$bin/relievo" describe; done | median | sed 's/^/relievo describe, CPU ms: /'

"$bin/relievo" export sample:bricks@2048 --target textures -o "$work/set" --quiet
files=$(find "$work/set" -name '*.png' | sort)
plain='' render='' small=''
for i in 1 2 3 4 5 6 7 8 9; do
    plain+="$(wall "$bin/read_images" $files)"$'\n'
    render+="$(wall "$bin/relievo" render "$work/set" --samples 1 --size 800x600 -o "$work/x.png")"$'\n'
    small+="$(wall "$bin/relievo" render sample:bricks@16 --samples 1 --size 800x600 -o "$work/x.png")"$'\n'
done
a=$(printf '%s' "$plain" | median) b=$(printf '%s' "$render" | median) c=$(printf '%s' "$small" | median)
echo "2K set ($(echo "$files" | wc -l) files): OpenImageIO alone $a ms, relievo render $b ms, a render without files (context, frame, writing) $c ms"
awk -v a="$a" -v b="$b" -v c="$c" 'BEGIN {printf "render / (OpenImageIO alone + frame) = %.2f\n", b / (a + c)}'
