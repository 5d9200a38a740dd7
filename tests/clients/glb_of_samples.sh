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
  for set in "$data"/materials/*/; do
    if [ ${#found[@]} -lt 3 ] && [ -n "$(find "$set" -maxdepth 1 -iname '*disp*.png' -o -maxdepth 1 -iname '*height*.png')" ]; then
      found+=("$set")
    fi
  done
  sources+=("${found[@]}")
fi
meshes=(sphere plane torus box cylinder sphere)
n=0
for source in "${sources[@]}"; do
  "$relievo" export "$source" --target gltf --mesh "${meshes[$n]}" --size 512 --set tiling=$((n + 1)) --quiet -o "$folder/material_$n.glb"
  n=$((n + 1))
done
echo "exported $n materials"
