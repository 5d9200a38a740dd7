#!/usr/bin/env bash
# Exports real sets and a sample for some targets: write.sh RELIEVO FOLDER DATA TARGETS [OPTION...]; FOLDER/SET/TARGET holds each (FOLDER/SET with one target).
# Prints nothing but errors. Sets that DATA lacks are left out.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
relievo=$1 folder=$2 data=$3 targets=$4
shift 4
rm -rf "$folder"
mkdir -p "$folder"
sources=(sample:bricks@256)
for set in 3dtextures_rock_024_dx ambientcg_bricks076c_dds panda_terrain_16bit; do
  if [ -d "$data/materials/$set" ]; then
    sources+=("$data/materials/$set")
  fi
done
"$relievo" export "${sources[@]}" --target "$targets" --size 512 --quiet "$@" -o "$folder"
