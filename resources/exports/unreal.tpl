{"textures": [
    {"key": "color", "file": "T_{{name}}_BaseColor.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "T_{{name}}_Normal.png", "channels": ["normal_x", "normal_y_directx", "normal_z"]},
    {"key": "orm", "file": "T_{{name}}_ORM.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "T_{{name}}_Emissive.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "T_{{name}}_Height.png", "channels": ["height"], "bits": 16},
    {"key": "bound_high", "file": "T_{{name}}_BoundHigh.png", "channels": ["bound_high_r", "bound_high_g", "bound_high_b", "bound_high_a"]},
    {"key": "bound_low", "file": "T_{{name}}_BoundLow.png", "channels": ["bound_low_r", "bound_low_g", "bound_low_b", "bound_low_a"]}
]}
=== {{name}}.py
"""{{{title}}}, written by Relievo {{version}}.

Run it in Unreal's editor (Tools, Execute Python Script): it imports the textures into /Game/{{identifier}} and makes the material M_{{identifier}}.
Depth: {{depthCentimetres}} cm on a tile of {{tileMetres}} m.
{{#ownShader}}
The engine's parallax occlusion is wired. Beside it stands a Custom node, "Relievo", that searches by {{technique}}; to draw by it, connect its output
to the UVs of the texture samples in place of Parallax UVs (it tells no Pixel Depth Offset), or set WIRE_OWN to True and run the script again.
{{/ownShader}}
"""
import os

import unreal

FOLDER = os.path.dirname(os.path.abspath(__file__))
TARGET = "/Game/{{identifier}}"
PARALLAX = "/Engine/Functions/Engine_MaterialFunctions01/Texturing/ParallaxOcclusionMapping"
editing = unreal.MaterialEditingLibrary
WIRE_OWN = False  # draw by the Custom node, if there is one, in place of the engine's parallax occlusion
{{#ownShader}}

# UVs, View (towards the eye, tangent space), Depth (of white to black, in UVs) and Plane (the height on the surface) are the node's inputs.
SEARCH = """
{{{searchUnreal}}}
float3 eye = normalize(View);
float cosine = clamp(eye.z, 0.002f, 1.0f);
Ray ray;
ray.duv = eye.xy * (-Depth / cosine);
ray.uv = UVs - ray.duv * (1.0f - Plane);
ray.cosView = cosine;
ray.end = 1.0f;
return relief.trace(ray).uv;
"""
{{/ownShader}}


def texture(file, compression, srgb=False, mips=True, resident=False):
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
    if not mips:
        made.set_editor_property("mip_gen_settings", unreal.TextureMipGenSettings.TMGS_NO_MIPMAPS)
    made.set_editor_property("never_stream", resident)  # texels that a search counts are those of the whole texture
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
    height.set_editor_property("texture", texture("{{height.file}}", unreal.TextureCompressionSettings.TC_GRAYSCALE, resident=True))
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
    {{#ownShader}}
    own = node(unreal.MaterialExpressionCustom, -1000, 900)
    own.set_editor_property("description", "Relievo")
    own.set_editor_property("code", SEARCH)
    own.set_editor_property("output_type", unreal.CustomMaterialOutputType.CMOT_FLOAT2)
    view = node(unreal.MaterialExpressionCameraVectorWS, -1600, 900)
    tangent = node(unreal.MaterialExpressionTransform, -1400, 900)
    tangent.set_editor_property("transform_source_type", unreal.MaterialVectorCoordTransformSource.TRANSFORMSOURCE_WORLD)
    tangent.set_editor_property("transform_type", unreal.MaterialVectorCoordTransform.TRANSFORM_TANGENT)
    editing.connect_material_expressions(view, "", tangent, "")

    def value(number, y):
        constant = node(unreal.MaterialExpressionConstant, -1400, y)
        constant.set_editor_property("r", number)
        return constant

    pins = {"UVs": place, "View": tangent, "Depth": value({{number}}, 1050), "Plane": value({{midlevel}}, 1100), "heightMap": height}
    {{#bound_high}}
    for pin, file, y in (("boundHighMap", "{{bound_high.file}}", 1150), ("boundLowMap", "{{bound_low.file}}", 1350)):
        pins[pin] = node(unreal.MaterialExpressionTextureObject, -1400, y)
        pins[pin].set_editor_property("texture", texture(file, unreal.TextureCompressionSettings.TC_VECTOR_DISPLACEMENTMAP, mips=False, resident=True))
        pins[pin].set_editor_property("sampler_type", unreal.MaterialSamplerType.SAMPLERTYPE_LINEAR_COLOR)
    {{/bound_high}}
    inputs = []
    for pin in pins:
        named = unreal.CustomInput()
        named.set_editor_property("input_name", pin)
        inputs.append(named)
    own.set_editor_property("inputs", inputs)
    for pin, source in pins.items():
        editing.connect_material_expressions(source, "", own, pin)
    where, output = own, ""
    {{/ownShader}}
    if not WIRE_OWN:
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
