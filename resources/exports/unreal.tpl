{"textures": [
    {"key": "color", "file": "T_{{name}}_BaseColor.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "T_{{name}}_Normal.png", "channels": ["normal_x", "normal_y_directx", "normal_z"]},
    {"key": "orm", "file": "T_{{name}}_ORM.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "T_{{name}}_Emissive.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "T_{{name}}_Height.png", "channels": ["height"], "bits": 16}
]}
=== {{name}}.py
"""{{{title}}}, written by Relievo {{version}}.

Run it in Unreal's editor (Tools, Execute Python Script): it imports the textures into /Game/{{identifier}} and makes the material M_{{identifier}}.
Depth: {{depthCentimetres}} cm on a tile of {{tileMetres}} m.
"""
import os

import unreal

FOLDER = os.path.dirname(os.path.abspath(__file__))
TARGET = "/Game/{{identifier}}"
PARALLAX = "/Engine/Functions/Engine_MaterialFunctions01/Texturing/ParallaxOcclusionMapping"
editing = unreal.MaterialEditingLibrary


def texture(file, compression, srgb=False):
    task = unreal.AssetImportTask()
    task.filename = os.path.join(FOLDER, file)
    task.destination_path = TARGET
    task.automated = True
    task.replace_existing = True
    task.save = True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    made = unreal.load_asset(TARGET + "/" + os.path.splitext(file)[0])
    made.set_editor_property("srgb", srgb)
    made.set_editor_property("compression_settings", compression)
    unreal.EditorAssetLibrary.save_loaded_asset(made)
    return made


def relief_material():
    tools = unreal.AssetToolsHelpers.get_asset_tools()
    material = tools.create_asset("M_{{identifier}}", TARGET, unreal.Material, unreal.MaterialFactoryNew())

    def node(kind, x, y):
        return editing.create_material_expression(material, kind, x, y)

    uv = node(unreal.MaterialExpressionTextureCoordinate, -1600, 0)
    uv.set_editor_property("u_tiling", {{tiling}})
    uv.set_editor_property("v_tiling", {{tiling}})
    place = node(unreal.MaterialExpressionAdd, -1400, 0)
    shift = node(unreal.MaterialExpressionConstant2Vector, -1600, 150)
    shift.set_editor_property("r", {{offsetU}})
    shift.set_editor_property("g", {{offsetV}})
    editing.connect_material_expressions(uv, "", place, "A")
    editing.connect_material_expressions(shift, "", place, "B")
    where, output = place, ""

    {{#height}}
    relief = node(unreal.MaterialExpressionMaterialFunctionCall, -1000, 0)
    relief.set_material_function(unreal.load_asset(PARALLAX))
    height = node(unreal.MaterialExpressionTextureObject, -1400, 300)
    height.set_editor_property("texture", texture("{{height.file}}", unreal.TextureCompressionSettings.TC_GRAYSCALE))
    height.set_editor_property("sampler_type", unreal.MaterialSamplerType.SAMPLERTYPE_LINEAR_GRAYSCALE)
    channel = node(unreal.MaterialExpressionConstant4Vector, -1400, 500)
    channel.set_editor_property("constant", unreal.LinearColor(1, 0, 0, 0))  # the function's own default is alpha

    def number(value, pin, y):
        constant = node(unreal.MaterialExpressionConstant, -1400, y)
        constant.set_editor_property("r", value)
        editing.connect_material_expressions(constant, "", relief, pin)

    number({{minSteps}}, "Min Steps", 650)
    number({{maxSteps}}, "Max Steps", 700)
    number({{number}}, "Height Ratio", 750)
    number({{midlevel}}, "Reference Plane", 800)
    editing.connect_material_expressions(height, "", relief, "Heightmap Texture")
    editing.connect_material_expressions(place, "", relief, "UVs")
    editing.connect_material_expressions(channel, "", relief, "Heightmap Channel")
    editing.connect_material_property(relief, "Pixel Depth Offset", unreal.MaterialProperty.MP_PIXEL_DEPTH_OFFSET)
    where, output = relief, "Parallax UVs"
    {{/height}}

    def sample(made, kind, y):
        sampler = node(unreal.MaterialExpressionTextureSample, -500, y)
        sampler.set_editor_property("texture", made)
        sampler.set_editor_property("sampler_type", kind)
        editing.connect_material_expressions(where, output, sampler, "UVs")
        return sampler

    {{#color}}
    color = sample(texture("{{color.file}}", unreal.TextureCompressionSettings.TC_DEFAULT, True), unreal.MaterialSamplerType.SAMPLERTYPE_COLOR, -400)
    tint = node(unreal.MaterialExpressionConstant3Vector, -500, -600)
    tint.set_editor_property("constant", unreal.LinearColor({{colorR}}, {{colorG}}, {{colorB}}, 1))
    tinted = node(unreal.MaterialExpressionMultiply, -200, -450)
    editing.connect_material_expressions(color, "RGB", tinted, "A")
    editing.connect_material_expressions(tint, "", tinted, "B")
    editing.connect_material_property(tinted, "", unreal.MaterialProperty.MP_BASE_COLOR)
    {{/color}}
    {{#opacityMap}}
    material.set_editor_property("blend_mode", unreal.BlendMode.BLEND_MASKED)
    editing.connect_material_property(color, "A", unreal.MaterialProperty.MP_OPACITY_MASK)
    {{/opacityMap}}
    {{#orm}}
    orm = sample(texture("{{orm.file}}", unreal.TextureCompressionSettings.TC_MASKS), unreal.MaterialSamplerType.SAMPLERTYPE_MASKS, 0)
    editing.connect_material_property(orm, "R", unreal.MaterialProperty.MP_AMBIENT_OCCLUSION)
    editing.connect_material_property(orm, "G", unreal.MaterialProperty.MP_ROUGHNESS)
    editing.connect_material_property(orm, "B", unreal.MaterialProperty.MP_METALLIC)
    {{/orm}}
    {{#normal}}
    normal = sample(texture("{{normal.file}}", unreal.TextureCompressionSettings.TC_NORMALMAP), unreal.MaterialSamplerType.SAMPLERTYPE_NORMAL, 400)
    editing.connect_material_property(normal, "RGB", unreal.MaterialProperty.MP_NORMAL)
    {{/normal}}
    {{#emissive}}
    light = sample(texture("{{emission_map.file}}", unreal.TextureCompressionSettings.TC_DEFAULT, True), unreal.MaterialSamplerType.SAMPLERTYPE_COLOR, 800)
    editing.connect_material_property(light, "RGB", unreal.MaterialProperty.MP_EMISSIVE_COLOR)
    {{/emissive}}
    editing.recompile_material(material)
    unreal.EditorAssetLibrary.save_loaded_asset(material)
    return material


relief_material()
