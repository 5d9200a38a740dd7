{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "bump", "file": "{{name}}_normal_height.png", "channels": ["normal_x", "normal_y", "normal_z", "height"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height_bytes", "file": "{{name}}_height_bytes.png", "channels": ["height_high_byte", "height_low_byte", "0.0"]},
    {"key": "bound_high", "file": "{{name}}_bound_high.png", "channels": ["bound_high_r", "bound_high_g", "bound_high_b", "bound_high_a"]},
    {"key": "bound_low", "file": "{{name}}_bound_low.png", "channels": ["bound_low_r", "bound_low_g", "bound_low_b", "bound_low_a"]}
]}
=== {{name}}.mjs
// {{{title}}}, written by Relievo {{version}}. For a right-handed scene and v up (the default of Texture).
// material(BABYLON, scene, "folder of the pictures/"): a PBRMaterial with parallax occlusion.
{{#ownShader}}
// reliefMaterial(BABYLON, scene, "folder of the pictures/"): a shader that searches the relief behind each pixel by {{technique}}; its light is
// the uniform lightDirection (unit, world space: setArray3), its surroundings are a formula's.
{{/ownShader}}
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
{{#ownShader}}

const uniforms = {{{uniformsLoaders}}};

const fragment = `{{{fragmentLoaders}}}`;

const vertex = `#version 300 es\nprecision highp float;
in vec3 position;
in vec3 normal;
in vec2 uv;
uniform mat4 world, viewProjection;
uniform mat2 textureFromMesh;
uniform vec2 textureShift;
uniform float pushOut;
out vec3 worldPosition, surfaceNormal;
out vec2 textureUv;
void main() {
  surfaceNormal = normalize(transpose(inverse(mat3(world))) * normal);
  worldPosition = vec3(world * vec4(position, 1.0)) + surfaceNormal * pushOut; // so that height {{midlevel}} lies on the mesh
  textureUv = textureFromMesh * vec2(uv.x, 1.0 - uv.y) + textureShift;
  gl_Position = viewProjection * vec4(worldPosition, 1.0);
}
`;

export function reliefMaterial(BABYLON, scene, folder = "") {
  const files = [];
  const picture = (...file) => files.push(file);
  {{#color}}
  picture("colorMap", "{{color.file}}", "color");
  {{/color}}
  {{#bump}}
  picture("normalMap", "{{bump.file}}", "data");
  {{/bump}}
  {{#orm}}
  picture("ormMap", "{{orm.file}}", "data");
  {{/orm}}
  {{#emission_map}}
  picture("emissionMap", "{{emission_map.file}}", "color");
  {{/emission_map}}
  {{#height_bytes}}
  picture("heightMap", "{{height_bytes.file}}", "texels");
  {{/height_bytes}}
  {{#bound_high}}
  picture("boundHighMap", "{{bound_high.file}}", "texels");
  picture("boundLowMap", "{{bound_low.file}}", "texels");
  {{/bound_high}}
  const m = new BABYLON.ShaderMaterial("{{title}}", scene, {
    vertexSource: vertex, fragmentSource: "#version 300 es\n#define position worldPosition\n#define eye cameraPosition\n" + fragment,
  }, {
    attributes: ["position", "normal", "uv"], samplers: files.map(([name]) => name),
    uniforms: ["world", "viewProjection", "cameraPosition", ...Object.keys(uniforms), ...files.map(([name]) => name + "Levels")],
  });
  const setters = { float: "setFloat", int: "setInt", bool: "setInt", vec2: "setArray2", vec3: "setArray3", vec4: "setArray4", mat2: "setMatrix2x2" };
  for (const [name, [type, value]] of Object.entries(uniforms)) m[setters[type]](name, value);
  for (const [name, file, kind] of files) {
    const isTexels = kind === "texels";
    const texture = new BABYLON.Texture(folder + file, scene, {
      noMipmap: isTexels, invertY: false, useSRGBBuffer: kind === "color", // v goes down in the shader
      samplingMode: isTexels ? BABYLON.Texture.NEAREST_SAMPLINGMODE : BABYLON.Texture.TRILINEAR_SAMPLINGMODE,
      onLoad: () => m.setFloat(name + "Levels", Math.log2(Math.max(texture.getSize().width, texture.getSize().height))),
    });
    texture.wrapU = texture.wrapV = BABYLON.Texture.{{#repeat}}WRAP{{/repeat}}{{^repeat}}CLAMP{{/repeat}}_ADDRESSMODE;
    if (isTexels) texture.anisotropicFilteringLevel = 1;
    m.setTexture(name, texture);
  }
  return m;
}
{{/ownShader}}
