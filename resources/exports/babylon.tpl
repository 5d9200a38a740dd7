{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "bump", "file": "{{name}}_normal_height.png", "channels": ["normal_x", "normal_y", "normal_z", "height"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true}
]}
=== {{name}}.mjs
// {{{title}}}, written by Relievo {{version}}: a PBRMaterial with parallax occlusion. For a right-handed scene and v up (the default of Texture).
// material(BABYLON, scene, "folder of the pictures/")
export function material(BABYLON, scene, folder = "") {
  const picture = (file, mips = true) => {
    const texture = new BABYLON.Texture(folder + file, scene, !mips, true,
      mips ? BABYLON.Texture.TRILINEAR_SAMPLINGMODE : BABYLON.Texture.BILINEAR_SAMPLINGMODE);
    texture.uScale = texture.vScale = {{tiling}};
    texture.uOffset = {{offsetU}};
    texture.vOffset = {{offsetVFlipped}};
    texture.wrapU = texture.wrapV = BABYLON.Texture.{{#repeat}}WRAP{{/repeat}}{{^repeat}}CLAMP{{/repeat}}_ADDRESSMODE;
    texture.uRotationCenter = texture.vRotationCenter = 0;
    if (!mips) texture.anisotropicFilteringLevel = 1;
    return texture;
  };
  const m = new BABYLON.PBRMaterial("{{title}}", scene);
  m.albedoColor = new BABYLON.Color3({{colorR}}, {{colorG}}, {{colorB}});
  {{#color}}
  m.albedoTexture = picture("{{color.file}}");
  {{/color}}
  {{^color}}
  // Without a colour texture PBRMaterial leaves parallax out.
  m.albedoTexture = BABYLON.RawTexture.CreateRGBATexture(new Uint8Array([255, 255, 255, 255]), 1, 1, scene);
  {{/color}}
  {{#opacityMap}}
  m.albedoTexture.hasAlpha = true;
  m.transparencyMode = BABYLON.PBRMaterial.PBRMATERIAL_ALPHATEST;
  m.alphaCutOff = 0.5;
  {{/opacityMap}}
  m.roughness = {{roughness}};
  m.metallic = {{metallic}};
  {{#orm}}
  m.metallicTexture = picture("{{orm.file}}");
  m.useRoughnessFromMetallicTextureAlpha = false;
  m.useRoughnessFromMetallicTextureGreen = true;
  m.useMetallnessFromMetallicTextureBlue = true;
  m.useAmbientOcclusionFromMetallicTextureRed = true;
  {{/orm}}
  {{#emissive}}
  m.emissiveTexture = picture("{{emission_map.file}}");
  m.emissiveColor = BABYLON.Color3.White();
  m.emissiveIntensity = {{emission}};
  {{/emissive}}
  {{#bump}}
  m.bumpTexture = picture("{{bump.file}}", false); // its alpha is the height; mip levels and averages along the view would spoil the march
  m.bumpTexture.level = 1; // anything else changes the march
  m.useParallax = true;
  m.useParallaxOcclusion = {{#searches}}true{{/searches}}{{^searches}}false{{/searches}};
  m.parallaxScaleBias = {{number}};
  {{/bump}}
  return m;
}
