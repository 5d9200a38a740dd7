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
// {{{title}}}, written by Relievo {{version}}.
// await material(pc, app, "folder of the pictures/"): a StandardMaterial with parallax occlusion (PlayCanvas 2.22 or later).
{{#ownShader}}
// await reliefMaterial(pc, app, "folder of the pictures/"): a shader that searches the relief behind each pixel by {{technique}}; its light is
// the parameter lightDirection (unit, world space), its surroundings are a formula's.
{{/ownShader}}
function loader(pc, app, folder) {
  return (file, srgb, mipmaps = true) => new Promise((done, fail) => {
    const asset = new pc.Asset(file, "texture", { url: folder + file }, { mipmaps, srgb });
    asset.once("load", () => {
      asset.resource.addressU = asset.resource.addressV = pc.ADDRESS_{{#repeat}}REPEAT{{/repeat}}{{^repeat}}CLAMP_TO_EDGE{{/repeat}};
      if (!mipmaps) asset.resource.minFilter = pc.FILTER_LINEAR;
      done(asset.resource);
    });
    asset.once("error", (message) => fail(new Error(message)));
    app.assets.add(asset);
    app.assets.load(asset);
  });
}

export async function material(pc, app, folder = "") {
  const picture = loader(pc, app, folder);
  const m = new pc.StandardMaterial();
  m.name = "{{title}}";
  const maps = [];
  const map = (name, texture) => {
    m[name] = texture;
    maps.push(name);
  };
  m.diffuse = new pc.Color({{srgbColorR}}, {{srgbColorG}}, {{srgbColorB}});
  {{#color}}
  map("diffuseMap", await picture("{{color.file}}", true));
  {{/color}}
  {{#opacityMap}}
  map("opacityMap", m.diffuseMap);
  m.opacityMapChannel = "a";
  m.alphaTest = 0.5;
  {{/opacityMap}}
  m.useMetalness = true;
  m.metalness = {{metallic}};
  m.gloss = {{roughness}}; // inverted: it is the roughness
  m.glossInvert = true;
  {{#orm}}
  const orm = await picture("{{orm.file}}", false);
  map("aoMap", orm);
  m.aoMapChannel = "r";
  map("glossMap", orm);
  m.glossMapChannel = "g";
  map("metalnessMap", orm);
  m.metalnessMapChannel = "b";
  {{/orm}}
  {{#normal}}
  map("normalMap", await picture("{{normal.file}}", false));
  m.bumpiness = {{normalStrength}};
  {{/normal}}
  {{#emissive}}
  map("emissiveMap", await picture("{{emission_map.file}}", true));
  m.emissive = new pc.Color(1, 1, 1);
  m.emissiveIntensity = {{emission}};
  {{/emissive}}
  {{#height}}
  map("heightMap", await picture("{{height.file}}", false, false));
  m.heightMapChannel = "r";
  m.heightMapFactor = {{number}};
  m.heightMapBase = {{midlevel}};
  m.parallaxMode = pc.PARALLAX_OCCLUSION ?? "occlusion";
  m.parallaxSamples = 16;
  {{/height}}
  for (const name of maps) {
    m[name + "Tiling"] = new pc.Vec2({{tiling}}, {{tiling}});
    m[name + "Offset"] = new pc.Vec2({{offsetU}}, {{offsetVFlipped}});
    m[name + "Rotation"] = {{rotationDegrees}};
  }
  m.update();
  return m;
}
{{#ownShader}}

const uniforms = {{{uniformsLoaders}}};

const fragment = `{{{fragmentLoaders}}}`;

const vertex = `in vec3 vertexPosition;
in vec3 vertexNormal;
in vec2 vertexUv;
uniform mat4 matrix_model;
uniform mat4 matrix_viewProjection;
uniform mat2 textureFromMesh;
uniform vec2 textureShift;
uniform float pushOut;
out vec3 worldPosition, surfaceNormal;
out vec2 textureUv;
void main() {
  surfaceNormal = normalize(transpose(inverse(mat3(matrix_model))) * vertexNormal);
  worldPosition = vec3(matrix_model * vec4(vertexPosition, 1.0)) + surfaceNormal * pushOut; // so that height {{midlevel}} lies on the mesh
  textureUv = textureFromMesh * vertexUv + textureShift;
  gl_Position = matrix_viewProjection * vec4(worldPosition, 1.0);
}
`;

export async function reliefMaterial(pc, app, folder = "") {
  const load = loader(pc, app, folder);
  const m = new pc.ShaderMaterial({
    uniqueName: "Relievo {{identifier}} {{technique}}", vertexGLSL: vertex,
    // PlayCanvas declares the output itself, and looks for its own uniforms' declarations.
    fragmentGLSL: "#define position worldPosition\n" + fragment.replace("layout(location = 0) out vec4 fragment;", "#define fragment gl_FragColor")
      .replace("uniform vec3 eye;", "uniform vec3 view_position;\n#define eye view_position"),
    attributes: { vertexPosition: pc.SEMANTIC_POSITION, vertexNormal: pc.SEMANTIC_NORMAL, vertexUv: pc.SEMANTIC_TEXCOORD0 },
  });
  for (const [name, [, value]] of Object.entries(uniforms)) m.setParameter(name, value);
  const picture = async (name, file, kind) => {
    const texture = await load(file, kind === "color", kind !== "texels");
    if (kind === "texels") texture.minFilter = texture.magFilter = pc.FILTER_NEAREST;
    m.setParameter(name, texture);
    m.setParameter(name + "Levels", Math.log2(Math.max(texture.width, texture.height)));
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
  m.update();
  return m;
}
{{/ownShader}}
