{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"]},
    {"key": "fine", "file": "{{name}}_height.exr", "channels": ["height"], "bits": 32, "when": "8 bits show"}
]}
=== {{name}}.tres
[gd_resource type="StandardMaterial3D" format=3]

{{#color}}
[ext_resource type="Texture2D" path="{{color.file}}" id="1_color"]
{{/color}}
{{#normal}}
[ext_resource type="Texture2D" path="{{normal.file}}" id="2_normal"]
{{/normal}}
{{#orm}}
[ext_resource type="Texture2D" path="{{orm.file}}" id="3_orm"]
{{/orm}}
{{#emissive}}
[ext_resource type="Texture2D" path="{{emission_map.file}}" id="4_emission"]
{{/emissive}}
{{#fine}}
[ext_resource type="Texture2D" path="{{fine.file}}" id="5_height"]
{{/fine}}
{{^fine}}
{{#height}}
[ext_resource type="Texture2D" path="{{height.file}}" id="5_height"]
{{/height}}
{{/fine}}

[resource]
resource_name = "{{title}}"
albedo_color = Color({{srgbColorR}}, {{srgbColorG}}, {{srgbColorB}}, 1)
{{#color}}
albedo_texture = ExtResource("1_color")
{{/color}}
{{#opacityMap}}
transparency = 2
alpha_scissor_threshold = 0.5
{{/opacityMap}}
roughness = {{roughness}}
metallic = {{metallic}}
{{#orm}}
roughness_texture = ExtResource("3_orm")
roughness_texture_channel = 1
metallic_texture = ExtResource("3_orm")
metallic_texture_channel = 2
ao_enabled = true
ao_texture = ExtResource("3_orm")
ao_texture_channel = 0
{{/orm}}
{{#normal}}
normal_enabled = true
normal_scale = {{normalStrength}}
normal_texture = ExtResource("2_normal")
{{/normal}}
{{#emissive}}
emission_enabled = true
emission_energy_multiplier = {{emission}}
emission_texture = ExtResource("4_emission")
{{/emissive}}
{{#height}}
heightmap_enabled = true
heightmap_scale = {{number}}
heightmap_deep_parallax = {{#searches}}true{{/searches}}{{^searches}}false{{/searches}}
{{#searches}}
heightmap_min_layers = {{minSteps}}
heightmap_max_layers = {{maxSteps}}
{{/searches}}
heightmap_texture = ExtResource("5_height")
{{/height}}
uv1_scale = Vector3({{tiling}}, {{tiling}}, {{tiling}})
uv1_offset = Vector3({{offsetU}}, {{offsetV}}, 0)
texture_repeat = {{#repeat}}true{{/repeat}}{{^repeat}}false{{/repeat}}
=== {{file}}.import each texture
[remap]

importer="texture"
type="CompressedTexture2D"

[params]

compress/mode=0
compress/normal_map={{#isNormal}}1{{/isNormal}}{{^isNormal}}2{{/isNormal}}
mipmaps/generate={{#isHeight}}false{{/isHeight}}{{^isHeight}}true{{/isHeight}}
process/normal_map_invert_y=false
process/hdr_as_srgb=false
detect_3d/compress_to=0
