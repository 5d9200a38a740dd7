{"textures": [
    {"key": "color", "file": "{{name}}_color.png", "channels": ["color_r", "color_g", "color_b", "opacity"], "srgb": true},
    {"key": "normal", "file": "{{name}}_normal.png", "channels": ["normal_x", "normal_y", "normal_z"]},
    {"key": "orm", "file": "{{name}}_orm.png", "channels": ["ao", "roughness", "metallic"]},
    {"key": "emission_map", "file": "{{name}}_emission.png", "channels": ["emission_r", "emission_g", "emission_b"], "srgb": true},
    {"key": "height", "file": "{{name}}_height.png", "channels": ["height"]}
]}
=== {{name}}.mjs
// {{{title}}}, written by Relievo {{version}}: a MeshStandardMaterial whose vertices are moved by the height map, so divide the mesh finely.
// await material(THREE, "folder of the pictures/")
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
