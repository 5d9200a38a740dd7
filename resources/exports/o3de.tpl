{"textures": [
    {"key": "color", "file": "{{name}}_basecolor.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "roughness_map", "file": "{{name}}_roughness.png", "channels": ["roughness"]},
    {"key": "metallic_map", "file": "{{name}}_metallic.png", "channels": ["metallic"]},
    {"key": "occlusion", "file": "{{name}}_ao.png", "channels": ["ao"]},
    {"key": "emission_map", "file": "{{name}}_emissive.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"], "bits": 16}
]}
=== {{name}}.material
{
    "materialType": "@gemroot:Atom_Feature_Common@/Assets/Materials/Types/StandardPBR.materialtype",
    "materialTypeVersion": 5,
    "propertyValues": {
        "baseColor.color": [{{colorR}}, {{colorG}}, {{colorB}}, 1.0],
        {{#color}}
        "baseColor.textureMap": "{{color.file}}",
        {{/color}}
        {{#opacityMap}}
        "opacity.mode": "Cutout",
        "opacity.alphaSource": "Packed",
        "opacity.factor": 0.5,
        {{/opacityMap}}
        {{#metallic_map}}
        "metallic.textureMap": "{{metallic_map.file}}",
        {{/metallic_map}}
        "metallic.factor": {{metallic}},
        {{#roughness_map}}
        "roughness.textureMap": "{{roughness_map.file}}",
        {{/roughness_map}}
        "roughness.factor": {{roughness}},
        {{#normal}}
        "normal.textureMap": "{{normal.file}}",
        "normal.factor": {{normalStrength}},
        {{/normal}}
        {{#occlusion}}
        "occlusion.diffuseTextureMap": "{{occlusion.file}}",
        "occlusion.diffuseFactor": {{aoStrength}},
        {{/occlusion}}
        {{#emissive}}
        "emissive.enable": true,
        "emissive.textureMap": "{{emission_map.file}}",
        {{/emissive}}
        {{#height}}
        "parallax.textureMap": "{{height.file}}",
        "parallax.factor": {{number}},
        "parallax.offset": 0.0,
        "parallax.algorithm": "{{#searches}}POM{{/searches}}{{^searches}}Basic{{/searches}}",
        "parallax.quality": "Medium",
        "parallax.pdo": true,
        "parallax.showClipping": false,
        {{/height}}
        "uv.tileU": {{tiling}},
        "uv.tileV": {{tiling}},
        "uv.offsetU": {{offsetU}},
        "uv.offsetV": {{offsetV}},
        "uv.rotateDegrees": {{rotationDegrees}}
    }
}
