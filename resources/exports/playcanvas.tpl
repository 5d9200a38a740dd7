{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"]}
]}
=== {{name}}.mjs
// {{{title}}}, written by Relievo {{version}}: a StandardMaterial with parallax occlusion (PlayCanvas 2.22 or later).
// await material(pc, app, "folder of the pictures/")
export async function material(pc, app, folder = "") {
  const picture = (file, srgb, mipmaps = true) => new Promise((done, fail) => {
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
