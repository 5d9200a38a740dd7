{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height_bytes", "file": "{{name}}_height_bytes.png", "channels": ["height_high_byte", "height_low_byte", "0.0"], "when": "exact search"},
    {"key": "height", "file": "{{name}}_height.exr", "channels": ["height"], "bits": 32, "when": "filtered search"},
    {"key": "bound_high", "file": "{{name}}_bound_high.png", "channels": ["bound_high_r", "bound_high_g", "bound_high_b", "bound_high_a"], "when": "codes"},
    {"key": "bound_low", "file": "{{name}}_bound_low.png", "channels": ["bound_low_r", "bound_low_g", "bound_low_b", "bound_low_a"], "when": "codes"},
    {"key": "bound", "file": "{{name}}_bound.exr", "channels": ["bound_r", "bound_g", "bound_b", "bound_a"], "bits": 32, "when": "no codes"}
]}
=== {{name}}.gdshader
// {{{title}}}: {{technique}}, written by Relievo {{version}}. SPDX-License-Identifier: MIT
shader_type spatial;
render_mode depth_prepass_alpha;

uniform float relief_depth = {{number}}; // m, black to white
uniform float push_out = {{pushOutMetres}}; // m: the mesh is pushed out by this, so that height {{midlevel}} lies on it
uniform vec2 tiling = vec2({{tiling}}, {{tiling}});
uniform vec2 offset = vec2({{offsetU}}, {{offsetV}});
uniform float turn = {{rotationRadians}}; // radians
uniform bool self_shadow = {{#selfShadow}}true{{/selfShadow}}{{^selfShadow}}false{{/selfShadow}};
uniform float shadow_bias : hint_range(0.0, 0.2) = {{shadowBias}}; // share of the depth
uniform bool cut_borders = false; // discards what a ray finds beyond the mesh's own UVs of 0 to 1
uniform vec4 tint : source_color = vec4({{srgbColorR}}, {{srgbColorG}}, {{srgbColorB}}, 1.0);
uniform float roughness : hint_range(0.0, 1.0) = {{roughness}};
uniform float metallic : hint_range(0.0, 1.0) = {{metallic}};
uniform float normal_strength = {{normalStrength}};
uniform float emission_strength = {{emission}};
uniform sampler2D color_map : source_color, filter_linear_mipmap_anisotropic, repeat_enable, hint_default_white;
uniform sampler2D normal_map : hint_normal, filter_linear_mipmap_anisotropic, repeat_enable;
uniform sampler2D orm_map : filter_linear_mipmap_anisotropic, repeat_enable, hint_default_white;
uniform sampler2D emission_map : source_color, filter_linear_mipmap_anisotropic, repeat_enable, hint_default_black;

{{{searchGodot}}}
// The dual of the texture's Jacobian, and where the search landed, for the light.
varying vec3 grad_u;
varying vec3 grad_v;
varying vec3 flat_normal;
varying vec3 landed; // uv and t

vec2 placed(vec2 uv)
{
    vec2 tiled = uv * tiling;
    return vec2(cos(turn) * tiled.x - sin(turn) * tiled.y, sin(turn) * tiled.x + cos(turn) * tiled.y) + offset;
}

void vertex()
{
    VERTEX += NORMAL * push_out;
}

void fragment()
{
    vec2 uv = placed(UV);
    vec3 px = dFdx(VERTEX);
    vec3 py = dFdy(VERTEX);
    vec2 tx = dFdx(uv);
    vec2 ty = dFdy(uv);
    float area = tx.x * ty.y - tx.y * ty.x;
    float inverse_area = abs(area) > 1e-20 ? 1.0 / area : 0.0;
    vec3 along_u = (px * ty.y - py * tx.y) * inverse_area;
    vec3 along_v = (py * tx.x - px * ty.x) * inverse_area;
    vec3 n = normalize(NORMAL);
    float volume = dot(n, cross(along_u, along_v));
    float inverse_volume = abs(volume) > 1e-20 ? 1.0 / volume : 0.0;
    vec3 gu = cross(along_v, n) * inverse_volume;
    vec3 gv = cross(n, along_u) * inverse_volume;
    float cosine = clamp(dot(n, VIEW), 0.002, 1.0);
    vec3 travel = VIEW * (-relief_depth / cosine);
    Hit hit = trace(Ray(uv, vec2(dot(travel, gu), dot(travel, gv)), cosine, 1.0));
    if (cut_borders) {
        vec2 back = hit.uv - offset;
        vec2 own = vec2(cos(turn) * back.x + sin(turn) * back.y, -sin(turn) * back.x + cos(turn) * back.y) / tiling;
        if (own.x < 0.0 || own.y < 0.0 || own.x > 1.0 || own.y > 1.0)
            discard;
    }
    vec4 color = textureGrad(color_map, hit.uv, tx, ty);
    {{#opacityMap}}
    if (color.a < 0.5)
        discard;
    {{/opacityMap}}
    vec3 orm = textureGrad(orm_map, hit.uv, tx, ty).rgb;
    ALBEDO = color.rgb * tint.rgb;
    AO = orm.r;
    ROUGHNESS = orm.g * roughness;
    METALLIC = orm.b * metallic;
    EMISSION = textureGrad(emission_map, hit.uv, tx, ty).rgb * emission_strength;
    vec3 bend = textureGrad(normal_map, hit.uv, tx, ty).rgb * 2.0 - 1.0;
    {{^normal}}
    bend = vec3(0.0, 0.0, 1.0);
    {{/normal}}
    bend.z = sqrt(max(1.0 - dot(bend.xy, bend.xy), 1e-4)); // Godot may keep two channels only
    if (dot(gu, gu) * dot(gv, gv) > 0.0)
        NORMAL = normalize(n * bend.z + (normalize(gu) * bend.x - normalize(gv) * bend.y) * normal_strength);
    vec3 point = VERTEX + VIEW * (-relief_depth / cosine * hit.t);
    vec4 clip = PROJECTION_MATRIX * vec4(point, 1.0);
#if CURRENT_RENDERER == RENDERER_COMPATIBILITY
    DEPTH = clip.z / clip.w * 0.5 + 0.5;
#else
    DEPTH = clip.z / clip.w;
#endif
    grad_u = gu;
    grad_v = gv;
    flat_normal = n;
    landed = vec3(hit.uv, hit.t);
}

void light()
{
    float facing = dot(NORMAL, LIGHT);
    float above = dot(flat_normal, LIGHT);
    float lit = facing > 0.0 && above > 0.0 ? 1.0 : 0.0;
    if (self_shadow && lit > 0.0) {
        // The same search, from where the light enters the relief down to the point seen.
        vec3 travel = LIGHT * (-relief_depth / max(above, 0.002));
        vec2 way = vec2(dot(travel, grad_u), dot(travel, grad_v));
        float end = landed.z - shadow_bias;
        if (end > 0.0 && trace(Ray(landed.xy - way * landed.z, way, max(above, 0.002), end)).found)
            lit = 0.0;
    }
    vec3 h = normalize(LIGHT + VIEW);
    float nl = max(facing, 1e-4);
    float nv = max(dot(NORMAL, VIEW), 1e-4);
    float alpha = max(ROUGHNESS * ROUGHNESS, 2e-3);
    float a2 = alpha * alpha;
    float nh = clamp(dot(NORMAL, h), 0.0, 1.0);
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float visibility = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2));
    vec3 f0 = mix(vec3(0.04), ALBEDO, METALLIC);
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - clamp(dot(VIEW, h), 0.0, 1.0), 5.0);
    vec3 arriving = LIGHT_COLOR * (ATTENUATION * lit * max(facing, 0.0) / PI);
    DIFFUSE_LIGHT += arriving * (1.0 - METALLIC);
    SPECULAR_LIGHT += arriving * fresnel * (a2 / (d * d) * visibility);
}
=== {{name}}.tres
[gd_resource type="ShaderMaterial" format=3]

[ext_resource type="Shader" path="{{name}}.gdshader" id="1_shader"]
{{#color}}
[ext_resource type="Texture2D" path="{{color.file}}" id="2_color"]
{{/color}}
{{#normal}}
[ext_resource type="Texture2D" path="{{normal.file}}" id="3_normal"]
{{/normal}}
{{#orm}}
[ext_resource type="Texture2D" path="{{orm.file}}" id="4_orm"]
{{/orm}}
{{#emissive}}
[ext_resource type="Texture2D" path="{{emission_map.file}}" id="5_emission"]
{{/emissive}}
{{#height_bytes}}
[ext_resource type="Texture2D" path="{{height_bytes.file}}" id="6_height"]
{{/height_bytes}}
{{#height}}
[ext_resource type="Texture2D" path="{{height.file}}" id="6_height"]
{{/height}}
{{#bound_high}}
[ext_resource type="Texture2D" path="{{bound_high.file}}" id="7_bound_high"]
[ext_resource type="Texture2D" path="{{bound_low.file}}" id="8_bound_low"]
{{/bound_high}}
{{#bound}}
[ext_resource type="Texture2D" path="{{bound.file}}" id="9_bound"]
{{/bound}}

[resource]
resource_name = "{{title}}"
shader = ExtResource("1_shader")
shader_parameter/relief_depth = {{number}}
shader_parameter/push_out = {{pushOutMetres}}
shader_parameter/tiling = Vector2({{tiling}}, {{tiling}})
shader_parameter/offset = Vector2({{offsetU}}, {{offsetV}})
shader_parameter/turn = {{rotationRadians}}
shader_parameter/self_shadow = {{#selfShadow}}true{{/selfShadow}}{{^selfShadow}}false{{/selfShadow}}
shader_parameter/shadow_bias = {{shadowBias}}
shader_parameter/cut_borders = false
shader_parameter/roughness = {{roughness}}
shader_parameter/metallic = {{metallic}}
shader_parameter/normal_strength = {{normalStrength}}
shader_parameter/emission_strength = {{emission}}
{{#color}}
shader_parameter/color_map = ExtResource("2_color")
{{/color}}
{{#normal}}
shader_parameter/normal_map = ExtResource("3_normal")
{{/normal}}
{{#orm}}
shader_parameter/orm_map = ExtResource("4_orm")
{{/orm}}
{{#emissive}}
shader_parameter/emission_map = ExtResource("5_emission")
{{/emissive}}
{{#height_bytes}}
shader_parameter/heightMap = ExtResource("6_height")
{{/height_bytes}}
{{#height}}
shader_parameter/heightMap = ExtResource("6_height")
{{/height}}
{{#bound_high}}
shader_parameter/boundHighMap = ExtResource("7_bound_high")
shader_parameter/boundLowMap = ExtResource("8_bound_low")
{{/bound_high}}
{{#bound}}
shader_parameter/boundMap = ExtResource("9_bound")
{{/bound}}
=== {{file}}.import each texture
[remap]

importer="texture"
type="CompressedTexture2D"

[params]

compress/mode=0
compress/normal_map={{#isNormal}}1{{/isNormal}}{{^isNormal}}2{{/isNormal}}
mipmaps/generate={{#isData}}false{{/isData}}{{^isData}}true{{/isData}}
process/fix_alpha_border=false
process/normal_map_invert_y=false
process/hdr_as_srgb=false
detect_3d/compress_to=0
