// Babylon.js: StandardMaterial or PBRMaterial, height in the alpha of bumpTexture.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
/* global BABYLON */
export async function run(job, canvas, h) {
  const engine = new BABYLON.Engine(canvas, false);
  const scene = new BABYLON.Scene(engine);
  scene.useRightHandedSystem = job.rhs;
  scene.clearColor = new BABYLON.Color4(0, 0, 0, 0);
  // Output as read: true would make StandardMaterial write c^2.2, false makes PBRMaterial write c^(1/2.2).
  scene.imageProcessingConfiguration.applyByPostProcess = job.material === 'pbr';

  // The picture is that of the right-handed scene in both cases: left-handed, z is negated,
  // in the mesh's numbers or (mirrored, as the glTF loader does) by its scaling.
  const side = job.rhs ? 1 : -1;
  const inMesh = job.mirrored ? 1 : side;
  const mesh = BABYLON.MeshBuilder.CreateGround('plane', { width: 1, height: 1, updatable: true }, scene);
  // v as the exporter means it: 'up' with Texture's default invertY = true, 'down' with
  // invertY = false (what the glTF loader does). Image top is at right-handed z = -0.5.
  const at = mesh.getVerticesData('position');
  const uv = [], tangent = [];
  for (let i = 0; i < at.length; i += 3) {
    const down = at[i + 2] * inMesh + 0.5;
    uv.push(at[i] + 0.5, job.vUp ? 1 - down : down);
    // glTF's rule: w makes cross(normal, tangent) * w point up in the image, -Z * inMesh;
    // cross(+Y, +X) is -Z.
    tangent.push(1, 0, 0, inMesh);
  }
  mesh.setVerticesData('uv', uv);
  if (job.mirrored) mesh.scaling.z = side;
  if (job.tangents) mesh.setVerticesData('tangent', tangent);

  const { data, n } = h.ramp();
  const ramp = new BABYLON.RawTexture(data, n, n, BABYLON.Constants.TEXTUREFORMAT_RGBA, scene, false, job.vUp,
    BABYLON.Texture.BILINEAR_SAMPLINGMODE, BABYLON.Constants.TEXTURETYPE_FLOAT);
  ramp.gammaSpace = false;
  ramp.wrapU = ramp.wrapV = BABYLON.Texture.WRAP_ADDRESSMODE;
  const bump = await new Promise((done, fail) => {
    const t = new BABYLON.Texture('/material/bump.png', scene, !job.mips, job.vUp,
      job.mips ? BABYLON.Texture.TRILINEAR_SAMPLINGMODE : BABYLON.Texture.BILINEAR_SAMPLINGMODE,
      () => done(t), (message) => fail(new Error(message)));
  });
  bump.level = job.level;
  bump.anisotropicFilteringLevel = 1;

  let m;
  if (job.material === 'pbr') {
    m = new BABYLON.PBRMaterial('m', scene);
    m.albedoTexture = ramp;   // Without an albedoTexture PBRMaterial leaves the parallax out.
    m.unlit = job.unlit;
    if (!job.unlit) {
      m.albedoColor = BABYLON.Color3.Black();
      m.metallic = 0;
      m.specularIntensity = 0;
      m.emissiveColor = BABYLON.Color3.White();
      m.emissiveTexture = ramp;
    }
  } else {
    m = new BABYLON.StandardMaterial('m', scene);
    m.disableLighting = job.unlit;
    m.specularColor = BABYLON.Color3.Black();
    m.emissiveColor = BABYLON.Color3.White();
    m.diffuseTexture = ramp;
  }
  // A light of no strength: with disableLighting StandardMaterial leaves out the mesh's tangents.
  if (!job.unlit) new BABYLON.HemisphericLight('l', BABYLON.Vector3.Up(), scene).intensity = 0;
  m.bumpTexture = bump;
  m.invertNormalMapX = job.invertX;
  m.invertNormalMapY = job.invertY;
  m.useParallax = job.mode !== 'off';
  m.useParallaxOcclusion = job.mode === 'occlusion';
  m.parallaxScaleBias = job.scale;
  mesh.material = m;

  const camera = new BABYLON.FreeCamera('c', BABYLON.Vector3.Zero(), scene);
  camera.fov = job.fov * Math.PI / 180;
  camera.minZ = 0.05;
  const target = new BABYLON.RenderTargetTexture('t', job.size, scene, false, true, BABYLON.Constants.TEXTURETYPE_FLOAT);
  target.renderList = [mesh];
  target.activeCamera = camera;
  target.clearColor = scene.clearColor;
  await scene.whenReadyAsync();
  for (const [i, shot] of job.shots.entries()) {
    const [x, y, z] = h.eye(shot);
    camera.position.set(x, y, z * side);
    camera.setTarget(BABYLON.Vector3.Zero());
    camera.computeWorldMatrix(true);
    while (!target.isReadyForRendering()) await h.frames(1);
    target.render();
    await h.send(`shot${i}`, await target.readPixels(), job.size, job.size);
  }
  const effect = mesh.subMeshes[0]._getDrawWrapper(target.renderPassId)?.effect ?? mesh.subMeshes[0].effect;
  return { version: BABYLON.Engine.Version, defines: (effect?.defines ?? '').split('\n').filter((l) => /BUMP|PARALLAX|TANGENT|UNLIT|NORMALXY/.test(l)) };
}
