"""Stands in for Unreal's module `unreal` as far as an exported script may go: run(FILE) runs it and checks what it wired.

Nodes, their properties and pins are the engine's; a name that is not listed here is an error. The code of a Custom node is compiled by
glslangValidator, in a function as the engine puts it into.
"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import runpy
import subprocess
import sys
import tempfile
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
    "CameraVectorWS": (set(), set(), {""}),
    "Transform": ({"transform_source_type", "transform_type"}, {""}, {""}),
    "Custom": ({"description", "code", "output_type", "inputs"}, None, {""}),  # its pins are those of `inputs`
    "TextureSample": ({"texture", "sampler_type"}, {"UVs"}, {"RGB", "R", "G", "B", "A"}),
    "MaterialFunctionCall": (
        set(),
        {"Min Steps", "Max Steps", "Height Ratio", "Heightmap Texture", "UVs", "Heightmap Channel", "Reference Plane", "Specify Manual Texture Size",
         "Manual Texture Size", "Render Shadows (Occlusion Mapping)", "Shadow Steps", "Shadow Penumbra", "Light Vector", "Use World Coordinates",
         "Transform To VertexNormal"},
        {"Parallax UVs", "Pixel Depth Offset", "Offset Only", "Shadow", "Material Complexity - Steps Debug", "Tangent Light Vector", "World Position"}),
}
WORDS = {
    "TextureCompressionSettings": {"TC_DEFAULT", "TC_NORMALMAP", "TC_MASKS", "TC_GRAYSCALE", "TC_HDR",
                                   "TC_VECTOR_DISPLACEMENTMAP"},
    "MaterialSamplerType": {"SAMPLERTYPE_COLOR", "SAMPLERTYPE_GRAYSCALE", "SAMPLERTYPE_LINEAR_GRAYSCALE", "SAMPLERTYPE_LINEAR_COLOR",
                            "SAMPLERTYPE_MASKS", "SAMPLERTYPE_NORMAL"},
    "MaterialProperty": {"MP_BASE_COLOR", "MP_METALLIC", "MP_ROUGHNESS", "MP_NORMAL", "MP_EMISSIVE_COLOR", "MP_OPACITY_MASK", "MP_AMBIENT_OCCLUSION",
                         "MP_PIXEL_DEPTH_OFFSET"},
    "CustomMaterialOutputType": {"CMOT_FLOAT1", "CMOT_FLOAT2", "CMOT_FLOAT3", "CMOT_FLOAT4"},
    "MaterialVectorCoordTransformSource": {"TRANSFORMSOURCE_TANGENT", "TRANSFORMSOURCE_LOCAL", "TRANSFORMSOURCE_WORLD"},
    "MaterialVectorCoordTransform": {"TRANSFORM_TANGENT", "TRANSFORM_LOCAL", "TRANSFORM_WORLD"},
    "TextureMipGenSettings": {"TMGS_FROM_TEXTURE_GROUP", "TMGS_NO_MIPMAPS", "TMGS_SIMPLE_AVERAGE"},
    "BlendMode": {"BLEND_OPAQUE", "BLEND_MASKED", "BLEND_TRANSLUCENT"},
}
SAMPLERS = {"TC_DEFAULT": {"SAMPLERTYPE_COLOR"}, "TC_NORMALMAP": {"SAMPLERTYPE_NORMAL"}, "TC_MASKS": {"SAMPLERTYPE_MASKS"},
            "TC_GRAYSCALE": {"SAMPLERTYPE_GRAYSCALE", "SAMPLERTYPE_LINEAR_GRAYSCALE"}, "TC_VECTOR_DISPLACEMENTMAP": {"SAMPLERTYPE_LINEAR_COLOR"}}


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
    material = Thing(inputs={}, nodes=[], known={"blend_mode", "two_sided"})
    imported = {}

    def import_tasks(tasks):
        for task in tasks:
            if not os.path.isfile(task.filename) or os.path.dirname(task.filename) != str(folder):
                raise ValueError(f"{task.filename} is not there")
            imported[task.destination_path + "/" + os.path.splitext(os.path.basename(task.filename))[0]] = task.filename

    def load(path):
        if path not in imported and path != PARALLAX:
            raise ValueError(f"there is no asset {path}")
        return Thing(path=path, known={"srgb", "compression_settings", "mip_gen_settings", "never_stream"})

    def connect(source, output, target, pin):
        pins = [one.values["input_name"] for one in target.values["inputs"]] if target.inputs is None else target.inputs
        if output not in source.outputs or pin not in pins:
            raise ValueError(f"no pin {type(source).__name__}.{output} -> {type(target).__name__}.{pin}")
        target.wired[pin] = source, output
        return True

    def connect_property(source, output, prop):
        if output not in source.outputs:
            raise ValueError(f"{type(source).__name__} has no output {output}")
        material.inputs[prop] = source, output

    def create(owner, kind, x, y):
        material.nodes.append(kind())
        return material.nodes[-1]

    nodes = {name: node_class(name, *rows) for name, rows in NODES.items()}
    # The unknown name of a word or class is an AttributeError, as in the engine.
    words = {name: types.SimpleNamespace(**{word: word for word in known}) for name, known in WORDS.items()}
    tools = types.SimpleNamespace(import_asset_tasks=import_tasks, create_asset=lambda name, path, kind, factory: material)
    made = types.ModuleType("unreal")
    made.__dict__.update(
        {"MaterialExpression" + name: kind for name, kind in nodes.items()}, **words, Material=Thing, MaterialFactoryNew=Thing, AssetImportTask=Thing,
        CustomInput=lambda: Thing(known={"input_name"}), LinearColor=lambda r, g, b, a=1.0: (r, g, b, a), load_asset=load,
        AssetToolsHelpers=types.SimpleNamespace(get_asset_tools=lambda: tools),
        EditorAssetLibrary=types.SimpleNamespace(save_loaded_asset=lambda asset: True),
        MaterialEditingLibrary=types.SimpleNamespace(
            create_material_expression=create, connect_material_expressions=connect,
            connect_material_property=connect_property, recompile_material=lambda owner: None))
    return made, material


def expect(condition, text):
    if not condition:
        raise ValueError(text)


def check_custom(node):
    """All pins are wired, and the code compiles: Unreal hands each texture over with its sampler, called NAME and NAMESampler."""
    pins = [one.values["input_name"] for one in node.values["inputs"]]
    expect(set(node.wired) == set(pins), f"of the Custom node's pins only {set(node.wired)} are wired")
    textures = [pin for pin in pins if type(node.wired[pin][0]).__name__ == "MaterialExpressionTextureObject"]
    takes = [f"Texture2D {t}, SamplerState {t}Sampler" for t in textures] + ["float2 UVs", "float3 View", "float Depth", "float Plane"]
    given = [f"{t}Given, {t}GivenSampler" for t in textures] + ["uv", "view", "0.1f", "1.0f"]
    expect("static " not in node.values["code"], "a struct inside of a function has no static members")
    structs, begin, body = node.values["code"].partition("Relief relief;")
    text = structs + "".join(f"Texture2D {t}Given : register(t{i});\nSamplerState {t}GivenSampler : register(s{i});\n" for i, t in enumerate(textures))
    text += f"float2 custom({', '.join(takes)})\n{{\n{begin}{body}}}\n"
    text += f"float4 main(float2 uv : TEXCOORD0, float3 view : TEXCOORD1) : SV_Target0 {{ return float4(custom({', '.join(given)}), 0.0f, 1.0f); }}\n"
    with tempfile.TemporaryDirectory() as folder:
        source, spirv = os.path.join(folder, "custom.hlsl"), os.path.join(folder, "custom.spv")
        with open(source, "w") as out:
            out.write(text)
        for command in (["glslangValidator", "-D", "-e", "main", "-S", "frag", "-V", source, "-o", spirv], ["spirv-val", spirv]):
            done = subprocess.run(command, capture_output=True, text=True)
            expect(done.returncode == 0, f"{command[0]}: {done.stdout[:600]}{done.stderr[:600]}")


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
    own = [node for node in material.nodes if type(node).__name__ == "MaterialExpressionCustom"]
    for node in own:
        check_custom(node)
    read = [source for node in [relief, *own] for source, _ in node.wired.values()]
    for sampler in [source for source, _ in material.inputs.values()] + read:
        if "texture" in sampler.values:
            compression = sampler.values["texture"].values["compression_settings"]
            expect(sampler.values["sampler_type"] in SAMPLERS[compression], f"{sampler.values['sampler_type']} of {compression}")
            expect(sampler.values["texture"].values["srgb"] == (sampler.values["sampler_type"] == "SAMPLERTYPE_COLOR"), "sRGB")
