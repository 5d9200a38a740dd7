{"textures": [
    {"key": "color", "file": "{{name}}_BaseColor.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_Normal.png", "channels": ["normal_x", "normal_y", "normal_z"], "bits": 16},
    {"key": "height", "file": "{{name}}_Height.png", "channels": ["height"], "bits": 16},
    {"key": "orm", "file": "{{name}}_OcclusionRoughnessMetallic.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_Emissive.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true}
]}
=== {{name}}_depth.txt
{{{title}}}
Height: white is high, height {{midlevel}} lies on the surface.
Depth from black to white: {{depthMillimetres}} mm = {{depthPercent}} % of a tile ({{tileMetres}} m) = {{depthUV}} in UV units ({{metresPerUV}} m).
Normals: OpenGL (green up), strength {{normalStrength}}. Tiling {{tiling}}, offset {{offsetU}} {{offsetV}}, turned by {{rotationDegrees}} degrees.
