#!/usr/bin/env bash
# Exports three materials as .glb into a folder: glb_of_samples.sh RELIEVO FOLDER [DATA]. Real sets when DATA holds them, else samples.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
relievo=$1 folder=$2 data=${3:-}
mkdir -p "$folder"
rm -f "$folder"/*.glb
sources=(sample:cobblestones sample:hammered sample:planks)
if [ -d "$data/materials" ]; then
  found=()
  has() { [ -n "$(find "$1" -maxdepth 1 -iname "*.[pj][np]g" | grep -iE "$2")" ]; }
  for set in "$data"/materials/*/; do
    if [ ${#found[@]} -lt 3 ] && has "$set" 'disp|height' && has "$set" 'color|albedo|diff'; then
      found+=("$set")
    fi
  done
  sources+=(${found[@]+"${found[@]}"})
fi
meshes=(sphere plane torus box cylinder sphere)
n=0
for source in "${sources[@]}"; do
  "$relievo" export "$source" --target gltf --mesh "${meshes[$n]}" --size 512 --set tiling=$((n + 1)) --quiet -o "$folder/material_$n.glb"
  n=$((n + 1))
done
echo "exported $n materials"
