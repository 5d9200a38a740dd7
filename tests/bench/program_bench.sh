#!/usr/bin/env bash
# Whole processes: the start of `relievo describe`, and `relievo render` of sets against OpenImageIO alone on the same files: of a 2K 16-bit one,
# and of the folders that are given. Usage: program_bench.sh FOLDER-OF-PROGRAMS [SET...]
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
bin=${1:?the folder of the programs}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
median() { sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }
cpu() { ( TIMEFORMAT='%U %S'; { time "$@" >/dev/null 2>&1; } 2>&1 ) | awk '{print int(($1 + $2) * 1000)}'; }

for i in 1 2 3 4 5 6 7 8 9; do cpu "$bin/relievo" describe; done | median | sed 's/^/relievo describe, CPU ms: /'

"$bin/relievo" export sample:bricks@2048 --target textures -o "$work/set" --quiet
for set in "$work/set" "${@:2}"; do
    files=$(find "$set" -maxdepth 1 -type f ! -name '*.json' | sort)
    plain='' render='' small=''
    for i in 1 2 3 4 5 6 7 8 9; do
        plain+="$(cpu "$bin/read_images" $files)"$'\n'
        render+="$(cpu "$bin/relievo" render "$set" --size 64x64 -o "$work/x.png")"$'\n'
        small+="$(cpu "$bin/relievo" render sample:bricks@16 --size 64x64 -o "$work/x.png")"$'\n'
    done
    a=$(printf '%s' "$plain" | median) b=$(printf '%s' "$render" | median) c=$(printf '%s' "$small" | median)
    echo "$(basename "$set") ($(echo "$files" | wc -l) files), CPU ms: OpenImageIO alone $a, relievo render $b, a render without files $c"
    awk -v a="$a" -v b="$b" 'BEGIN {printf "render / OpenImageIO alone = %.2f\n", b / a}'
done
