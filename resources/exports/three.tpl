{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"]},
    {"key": "height_bytes", "file": "{{name}}_height_bytes.png", "channels": ["height_high_byte", "height_low_byte", "0.0"]},
    {"key": "bound_high", "file": "{{name}}_bound_high.png", "channels": ["bound_high_r", "bound_high_g", "bound_high_b", "bound_high_a"]},
    {"key": "bound_low", "file": "{{name}}_bound_low.png", "channels": ["bound_low_r", "bound_low_g", "bound_low_b", "bound_low_a"]}
]}
=== {{name}}.mjs
// {{{title}}}, written by Relievo {{version}}. For meshes whose v goes up (as three.js's own shapes).
// await material(THREE, "folder of the pictures/"): a MeshStandardMaterial whose vertices are moved by the height map, so divide the mesh finely.
{{#ownShader}}
// await reliefMaterial(THREE, "folder of the pictures/"): a shader that searches the relief behind each pixel by {{technique}}; its light is the
// uniform lightDirection (unit, world space), its surroundings are a formula's.
{{/ownShader}}
export async function material(THREE, folder = "") {
  const loader = new THREE.TextureLoader();
  const picture = async (file, srgb) => {
    const texture = await loader.loadAsync(folder + file);
    texture.colorSpace = srgb ? THREE.SRGBColorSpace : THREE.NoColorSpace;
    texture.wrapS = texture.wrapT = THREE.{{#repeat}}RepeatWrapping{{/repeat}}{{^repeat}}ClampToEdgeWrapping{{/repeat}};
    texture.repeat.set({{tiling}}, {{tiling}});
    texture.offset.set({{offsetUUp}}, {{offsetVUp}}); // v goes up there
    texture.rotation = {{rotationRadians}};
    return texture;
  };
  const m = new THREE.MeshStandardMaterial({ name: "{{title}}" });
  m.color.setRGB({{colorR}}, {{colorG}}, {{colorB}});
  {{#color}}
  m.map = await picture("{{color.file}}", true);
  {{/color}}
  {{#opacityMap}}
  m.alphaTest = 0.5;
  {{/opacityMap}}
  m.roughness = {{roughness}};
  m.metalness = {{metallic}};
  {{#orm}}
  m.aoMap = m.roughnessMap = m.metalnessMap = await picture("{{orm.file}}", false);
  m.aoMapIntensity = {{aoStrength}};
  {{/orm}}
  {{#normal}}
  m.normalMap = await picture("{{normal.file}}", false);
  m.normalScale.set({{normalStrength}}, {{normalStrength}});
  {{/normal}}
  {{#emissive}}
  m.emissiveMap = await picture("{{emission_map.file}}", true);
  m.emissive.setRGB(1, 1, 1);
  m.emissiveIntensity = {{emission}};
  {{/emissive}}
  {{#height}}
  m.displacementMap = await picture("{{height.file}}", false);
  m.displacementScale = {{number}}; // metres from black to white
  m.displacementBias = {{biasMetres}}; // height {{midlevel}} stays on the mesh
  {{/height}}
  return m;
}
{{#ownShader}}

const uniforms = {{{uniformsLoaders}}};

const fragment = `{{{fragmentLoaders}}}`;

const vertex = `precision highp float;
in vec3 position;
in vec3 normal;
in vec2 uv;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
uniform mat2 textureFromMesh;
uniform vec2 textureShift;
uniform float pushOut;
out vec3 worldPosition, surfaceNormal;
out vec2 textureUv;
void main() {
  surfaceNormal = normalize(transpose(inverse(mat3(modelMatrix))) * normal);
  worldPosition = vec3(modelMatrix * vec4(position, 1.0)) + surfaceNormal * pushOut; // so that height {{midlevel}} lies on the mesh
  textureUv = textureFromMesh * vec2(uv.x, 1.0 - uv.y) + textureShift;
  gl_Position = projectionMatrix * viewMatrix * vec4(worldPosition, 1.0);
}
`;

export async function reliefMaterial(THREE, folder = "") {
  const loader = new THREE.TextureLoader();
  const m = new THREE.RawShaderMaterial({
    name: "{{title}}", glslVersion: THREE.GLSL3, vertexShader: vertex,
    fragmentShader: "#define position worldPosition\n#define eye cameraPosition\n" + fragment });
  for (const [name, [, value]] of Object.entries(uniforms)) m.uniforms[name] = { value };
  const picture = async (name, file, kind) => {
    const texture = await loader.loadAsync(folder + file);
    texture.flipY = false; // v goes down in the shader
    texture.colorSpace = kind === "color" ? THREE.SRGBColorSpace : THREE.NoColorSpace;
    texture.wrapS = texture.wrapT = THREE.{{#repeat}}RepeatWrapping{{/repeat}}{{^repeat}}ClampToEdgeWrapping{{/repeat}};
    if (kind === "texels") {
      texture.generateMipmaps = false;
      texture.minFilter = texture.magFilter = THREE.NearestFilter;
    }
    m.uniforms[name] = { value: texture };
    m.uniforms[name + "Levels"] = { value: Math.log2(Math.max(texture.image.width, texture.image.height)) };
  };
  await Promise.all([
    {{#color}}
    picture("colorMap", "{{color.file}}", "color"),
    {{/color}}
    {{#normal}}
    picture("normalMap", "{{normal.file}}", "data"),
    {{/normal}}
    {{#orm}}
    picture("ormMap", "{{orm.file}}", "data"),
    {{/orm}}
    {{#emission_map}}
    picture("emissionMap", "{{emission_map.file}}", "color"),
    {{/emission_map}}
    {{#height_bytes}}
    picture("heightMap", "{{height_bytes.file}}", "texels"),
    {{/height_bytes}}
    {{#bound_high}}
    picture("boundHighMap", "{{bound_high.file}}", "texels"),
    picture("boundLowMap", "{{bound_low.file}}", "texels"),
    {{/bound_high}}
  ]);
  return m;
}
{{/ownShader}}
