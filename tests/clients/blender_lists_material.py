# Run inside Blender: imports each .glb and checks that its material arrives with color, packed map and normal map.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import sys

import bpy
import numpy

# Blender 3.4's glTF importer uses aliases that NumPy 1.24 removed.
for alias in (bool, int, float, object):
    if alias.__name__ not in numpy.__dict__:
        setattr(numpy, alias.__name__, alias)


def images_behind(material):
    return [node.image.name for node in material.node_tree.nodes if node.type == "TEX_IMAGE" and node.image]


def check(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    meshes = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    assert meshes and meshes[0].data.uv_layers, f"{path}: no mesh with UVs"
    materials = {slot.material for mesh in meshes for slot in mesh.material_slots if slot.material}
    assert len(materials) == 1, f"{path}: {len(materials)} materials"
    material = materials.pop()
    kinds = {link.to_socket.name for link in material.node_tree.links}
    images = images_behind(material)
    assert any(name.startswith("color") for name in images), f"{path}: no base color in {images}"
    assert any(name.startswith("normal") for name in images), f"{path}: no normal map in {images}"
    assert {"Base Color", "Normal"} <= kinds, f"{path}: only {sorted(kinds)} are connected"
    print(f"{path}: material {material.name!r} with {sorted(images)}")


for path in sys.argv[sys.argv.index("--") + 1:]:
    check(path)
print("all materials listed")
