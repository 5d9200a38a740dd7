{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "depth", "file": "{{name}}_depth.png", "channels": ["depth"]}
]}
=== {{name}}.tres
[gd_resource type="SpatialMaterial" format=2]

{{#color}}
[ext_resource path="{{color.file}}" type="Texture" id=1]
{{/color}}
{{#normal}}
[ext_resource path="{{normal.file}}" type="Texture" id=2]
{{/normal}}
{{#orm}}
[ext_resource path="{{orm.file}}" type="Texture" id=3]
{{/orm}}
{{#emissive}}
[ext_resource path="{{emission_map.file}}" type="Texture" id=4]
{{/emissive}}
{{#depth}}
[ext_resource path="{{depth.file}}" type="Texture" id=5]
{{/depth}}

[resource]
resource_name = "{{title}}"
albedo_color = Color( {{srgbColorR}}, {{srgbColorG}}, {{srgbColorB}}, 1 )
{{#color}}
albedo_texture = ExtResource( 1 )
{{/color}}
{{#opacityMap}}
params_use_alpha_scissor = true
params_alpha_scissor_threshold = 0.5
{{/opacityMap}}
roughness = {{roughness}}
metallic = {{metallic}}
{{#orm}}
roughness_texture = ExtResource( 3 )
roughness_texture_channel = 1
metallic_texture = ExtResource( 3 )
metallic_texture_channel = 2
ao_enabled = true
ao_texture = ExtResource( 3 )
ao_texture_channel = 0
{{/orm}}
{{#normal}}
normal_enabled = true
normal_scale = {{normalStrength}}
normal_texture = ExtResource( 2 )
{{/normal}}
{{#emissive}}
emission_enabled = true
emission_energy = {{emission}}
emission_texture = ExtResource( 4 )
{{/emissive}}
{{#depth}}
depth_enabled = true
depth_scale = {{number}}
depth_deep_parallax = {{#searches}}true{{/searches}}{{^searches}}false{{/searches}}
{{#searches}}
depth_min_layers = {{minSteps}}
depth_max_layers = {{maxSteps}}
{{/searches}}
depth_texture = ExtResource( 5 )
{{/depth}}
uv1_scale = Vector3( {{tiling}}, {{tiling}}, {{tiling}} )
uv1_offset = Vector3( {{offsetU}}, {{offsetV}}, 0 )
=== {{file}}.import each texture
[remap]

importer="texture"
type="StreamTexture"

[params]

compress/mode=0
compress/normal_map={{#isNormal}}1{{/isNormal}}{{^isNormal}}2{{/isNormal}}
flags/repeat={{#repeat}}1{{/repeat}}{{^repeat}}0{{/repeat}}
flags/filter=true
flags/mipmaps={{#isHeight}}false{{/isHeight}}{{^isHeight}}true{{/isHeight}}
flags/anisotropic=false
flags/srgb=2
process/fix_alpha_border=false
process/premult_alpha=false
process/invert_color=false
process/normal_map_invert_y=false
stream=false
size_limit=0
detect_3d=false
svg/scale=1.0
