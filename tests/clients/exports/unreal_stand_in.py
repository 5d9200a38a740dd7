"""Stands in for Unreal's module `unreal` as far as an exported script may go: run(FILE) runs it and checks what it wired.

Nodes, their properties and pins are the engine's; a name that is not listed here is an error.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import runpy
import sys
import types

PARALLAX = "/Engine/Functions/Engine_MaterialFunctions01/Texturing/ParallaxOcclusionMapping"
# Of an expression: its properties, inputs, outputs ("" is the only or first one).
NODES = {
    "TextureCoordinate": ({"u_tiling", "v_tiling"}, set(), {""}),
    "Constant": ({"r"}, set(), {""}),
    "Constant2Vector": ({"r", "g"}, set(), {""}),
    "Constant3Vector": ({"constant"}, set(), {""}),
    "Constant4Vector": ({"constant"}, set(), {""}),
    "Add": (set(), {"A", "B"}, {""}),
    "Multiply": (set(), {"A", "B"}, {""}),
    "Rotator": (set(), {"Coordinate", "Time"}, {""}),
    "TextureObject": ({"texture", "sampler_type"}, set(), {""}),
    "TextureSample": ({"texture", "sampler_type"}, {"UVs"}, {"RGB", "R", "G", "B", "A"}),
    "MaterialFunctionCall": (
        set(),
        {"Min Steps", "Max Steps", "Height Ratio", "Heightmap Texture", "UVs", "Heightmap Channel", "Reference Plane", "Specify Manual Texture Size",
         "Manual Texture Size", "Render Shadows (Occlusion Mapping)", "Shadow Steps", "Shadow Penumbra", "Light Vector", "Use World Coordinates",
         "Transform To VertexNormal"},
        {"Parallax UVs", "Pixel Depth Offset", "Offset Only", "Shadow", "Material Complexity - Steps Debug", "Tangent Light Vector", "World Position"}),
}
WORDS = {
    "TextureCompressionSettings": {"TC_DEFAULT", "TC_NORMALMAP", "TC_MASKS", "TC_GRAYSCALE", "TC_HDR"},
    "MaterialSamplerType": {"SAMPLERTYPE_COLOR", "SAMPLERTYPE_GRAYSCALE", "SAMPLERTYPE_LINEAR_GRAYSCALE", "SAMPLERTYPE_LINEAR_COLOR",
                            "SAMPLERTYPE_MASKS", "SAMPLERTYPE_NORMAL"},
    "MaterialProperty": {"MP_BASE_COLOR", "MP_METALLIC", "MP_ROUGHNESS", "MP_NORMAL", "MP_EMISSIVE_COLOR", "MP_OPACITY_MASK", "MP_AMBIENT_OCCLUSION",
                         "MP_PIXEL_DEPTH_OFFSET"},
    "BlendMode": {"BLEND_OPAQUE", "BLEND_MASKED", "BLEND_TRANSLUCENT"},
}
SAMPLERS = {"TC_DEFAULT": {"SAMPLERTYPE_COLOR"}, "TC_NORMALMAP": {"SAMPLERTYPE_NORMAL"}, "TC_MASKS": {"SAMPLERTYPE_MASKS"},
            "TC_GRAYSCALE": {"SAMPLERTYPE_GRAYSCALE", "SAMPLERTYPE_LINEAR_GRAYSCALE"}}


class Thing:
    known = None  # its properties; None: any

    def __init__(self, **more):
        self.values = {}
        self.__dict__.update(more)

    def set_editor_property(self, name, value):
        if self.known is not None and name not in self.known:
            raise ValueError(f"{type(self).__name__} has no property {name}")
        self.values[name] = value


def node_class(name, properties, inputs, outputs):
    def made(self):
        Thing.__init__(self)
        self.wired = {}

    return type("MaterialExpression" + name, (Thing,), {"known": properties, "inputs": inputs, "outputs": outputs, "__init__": made,
                                                       "set_material_function": lambda self, function: setattr(self, "function", function.path)})


def module(folder):
    material = Thing(inputs={}, known={"blend_mode", "two_sided"})
    imported = {}

    def import_tasks(tasks):
        for task in tasks:
            if not os.path.isfile(task.filename) or os.path.dirname(task.filename) != str(folder):
                raise ValueError(f"{task.filename} is not there")
            imported[task.destination_path + "/" + os.path.splitext(os.path.basename(task.filename))[0]] = task.filename

    def load(path):
        if path not in imported and path != PARALLAX:
            raise ValueError(f"there is no asset {path}")
        return Thing(path=path, known={"srgb", "compression_settings"})

    def connect(source, output, target, pin):
        if output not in source.outputs or pin not in target.inputs:
            raise ValueError(f"no pin {type(source).__name__}.{output} -> {type(target).__name__}.{pin}")
        target.wired[pin] = source, output
        return True

    def connect_property(source, output, prop):
        if output not in source.outputs:
            raise ValueError(f"{type(source).__name__} has no output {output}")
        material.inputs[prop] = source, output

    nodes = {name: node_class(name, *rows) for name, rows in NODES.items()}
    # The unknown name of a word or class is an AttributeError, as in the engine.
    words = {name: types.SimpleNamespace(**{word: word for word in known}) for name, known in WORDS.items()}
    tools = types.SimpleNamespace(import_asset_tasks=import_tasks, create_asset=lambda name, path, kind, factory: material)
    made = types.ModuleType("unreal")
    made.__dict__.update(
        {"MaterialExpression" + name: kind for name, kind in nodes.items()}, **words, Material=Thing, MaterialFactoryNew=Thing, AssetImportTask=Thing,
        LinearColor=lambda r, g, b, a=1.0: (r, g, b, a), load_asset=load,
        AssetToolsHelpers=types.SimpleNamespace(get_asset_tools=lambda: tools),
        EditorAssetLibrary=types.SimpleNamespace(save_loaded_asset=lambda asset: True),
        MaterialEditingLibrary=types.SimpleNamespace(
            create_material_expression=lambda owner, kind, x, y: kind(), connect_material_expressions=connect,
            connect_material_property=connect_property, recompile_material=lambda owner: None))
    return made, material


def expect(condition, text):
    if not condition:
        raise ValueError(text)


def run(file):
    """Runs the script; what feeds the parallax node must be what the function wants."""
    made, material = module(file.parent.resolve())
    before = sys.modules.get("unreal")
    sys.modules["unreal"] = made
    try:
        runpy.run_path(str(file.resolve()))
    finally:
        sys.modules.pop("unreal")
        if before:
            sys.modules["unreal"] = before
    relief = material.inputs["MP_PIXEL_DEPTH_OFFSET"][0]
    expect(relief.function == PARALLAX, "another function than parallax occlusion mapping")
    expect(relief.wired["Heightmap Channel"][0].values["constant"] == (1, 0, 0, 0), "the height is in red")
    expect({"Min Steps", "Max Steps", "Height Ratio", "Reference Plane", "Heightmap Texture", "UVs"} <= set(relief.wired), f"only {set(relief.wired)} are wired")
    expect(0 < relief.wired["Height Ratio"][0].values["r"] < 1, "Height Ratio")
    for sampler in [source for source, _ in material.inputs.values()] + [relief.wired["Heightmap Texture"][0]]:
        if "texture" in sampler.values:
            compression = sampler.values["texture"].values["compression_settings"]
            expect(sampler.values["sampler_type"] in SAMPLERS[compression], f"{sampler.values['sampler_type']} of {compression}")
            expect(sampler.values["texture"].values["srgb"] == (sampler.values["sampler_type"] == "SAMPLERTYPE_COLOR"), "sRGB")
