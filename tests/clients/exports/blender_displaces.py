# Run inside Blender: runs each exported script and measures how far its material moves the vertices of a plane, exported scripts...
# What is promised is what the target `packed` tells of the same material, in a folder beside.
# Blender's own renderer is the ruler: an emission of the displaced position, seen from above, where each pixel lies on a vertex.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import re
import runpy
import sys
import tempfile

import bpy
import numpy

SIDE = 129  # vertices along the plane, and pixels


def heights(image):
    """Red, bottom row first, as Blender keeps pictures."""
    pixels = numpy.empty(len(image.pixels), numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(image.size[1], image.size[0], 4)[..., 0]


def sampled(picture, u, v):
    """Bilinear, repeating; v goes up."""
    rows, columns = picture.shape
    x, y = u * columns - 0.5, v * rows - 0.5
    i, j = numpy.floor(x).astype(int), numpy.floor(y).astype(int)
    a, b = x - i, y - j
    at = lambda dj, di: picture[(j + dj) % rows, (i + di) % columns]
    return (at(0, 0) * (1 - a) + at(0, 1) * a) * (1 - b) + (at(1, 0) * (1 - a) + at(1, 1) * a) * b


def plane():
    at = numpy.arange(SIDE) / (SIDE - 1)
    vertices = [(x, y, 0) for y in at for x in at]
    faces = [(k, k + 1, k + 1 + SIDE, k + SIDE) for j in range(SIDE - 1) for k in range(j * SIDE, j * SIDE + SIDE - 1)]
    mesh = bpy.data.meshes.new("plane")
    mesh.from_pydata(vertices, [], faces)
    layer = mesh.uv_layers.new(name="UVMap")
    for loop in mesh.loops:
        layer.data[loop.index].uv = vertices[loop.vertex_index][:2]
    thing = bpy.data.objects.new("plane", mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def render(scene):
    camera = bpy.data.cameras.new("above")
    camera.type = "ORTHO"
    camera.ortho_scale = SIDE / (SIDE - 1)
    eye = bpy.data.objects.new("above", camera)
    eye.location = (0.5, 0.5, 5)
    bpy.context.collection.objects.link(eye)
    scene.camera = eye
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    scene.cycles.filter_width = 0.01
    scene.cycles.max_bounces = 0
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.view_settings.view_transform = "Raw"
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "position.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        image.colorspace_settings.name = "Non-Color"
        pixels = numpy.empty(len(image.pixels), numpy.float32)
        image.pixels.foreach_get(pixels)
    return pixels.reshape(SIDE, SIDE, 4)[..., :3].astype(float)


def check(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    thing = plane()
    bpy.context.view_layer.objects.active = thing
    runpy.run_path(path, run_name="__main__")
    material = thing.active_material
    assert material, f"{path}: the plane got no material"
    nodes, links = material.node_tree.nodes, material.node_tree.links
    displace = next(node for node in nodes if node.type == "DISPLACEMENT")
    output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
    assert output.inputs["Displacement"].is_linked, f"{path}: displacement is not connected"
    method = material.displacement_method if hasattr(material, "displacement_method") else material.cycles.displacement_method
    assert method == "DISPLACEMENT", f"{path}: method {method}"
    place = next(node for node in nodes if node.type == "MAPPING")
    tiling, offset = place.inputs["Scale"].default_value, place.inputs["Location"].default_value
    picture = heights(displace.inputs["Height"].links[0].from_node.image)
    folder, script = os.path.split(path)
    told = open(os.path.join(folder, "..", "packed", script.replace(".py", "_depth.txt"))).read()
    promised = float(re.search(r"Depth from black to white: ([0-9.]+) mm", told).group(1)) / 1000
    midlevel = displace.inputs["Midlevel"].default_value
    # Its colour is where it lies.
    light, where = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeNewGeometry")
    links.new(where.outputs["Position"], light.inputs["Color"])
    links.new(light.outputs[0], output.inputs["Surface"])
    seen = render(bpy.context.scene)
    at = numpy.arange(SIDE) / (SIDE - 1)
    u, v = numpy.meshgrid(at, at)
    meant = (sampled(picture, u * tiling[0] + offset[0], v * tiling[1] + offset[1]) - midlevel) * promised
    inner = (slice(2, -2), slice(2, -2))
    got, meant = seen[..., 2][inner], meant[inner]
    # A line through what was seen and what was meant: its slope is the depth drawn, in promised ones.
    slope, shift = numpy.polyfit(meant.ravel(), got.ravel(), 1)
    away = numpy.abs(got - meant).max() / promised
    print(f"{os.path.basename(path)}: {promised * 1000:.2f} mm promised, {slope * promised * 1000:.2f} mm drawn, zero off by {shift / promised * 100:.3f} %, "
          f"median {numpy.median(numpy.abs(got - meant)) / promised * 100:.3f} %, largest {away * 100:.2f} % of the depth")
    assert abs(slope - 1) < 0.02 and abs(shift) < 0.02 * promised, f"{path}: another depth than promised"


for path in sys.argv[sys.argv.index("--") + 1:]:
    check(path)
print(f"Blender {bpy.app.version_string}: all depths are as promised")
