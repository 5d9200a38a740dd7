{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "roughness_map", "file": "{{name}}_roughness.png", "channels": ["roughness"]},
    {"key": "metallic_map", "file": "{{name}}_metallic.png", "channels": ["metallic"]},
    {"key": "occlusion", "file": "{{name}}_ao.png", "channels": ["ao"]},
    {"key": "opacity_map", "file": "{{name}}_opacity.png", "channels": ["opacity"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"], "bits": 16},
    {"key": "bound", "file": "{{name}}_bound.png", "channels": ["bound_r", "bound_g", "bound_b", "bound_a"], "bits": 16}
]}
=== relief_vertex.metal
{{{vertexMsl}}}
=== relief.metal
{{{fragmentMsl}}}
