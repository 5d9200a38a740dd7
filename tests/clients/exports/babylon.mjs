// Babylon.js with the exported modules: makes each material, tells its numbers, and draws the UVs that the shots fetch. See check_web.py.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
/* global BABYLON */
export async function run(job, canvas, h) {
  const engine = new BABYLON.Engine(canvas, false);
  const scene = new BABYLON.Scene(engine);
  scene.useRightHandedSystem = true;
  scene.clearColor = new BABYLON.Color4(0, 0, 0, 0);
  scene.imageProcessingConfiguration.applyByPostProcess = true; // colours as they are
  const plane = BABYLON.MeshBuilder.CreateGround('plane', { width: 1, height: 1, updatable: true }, scene);
  const at = plane.getVerticesData('position'), uv = [];
  for (let i = 0; i < at.length; i += 3) uv.push(at[i] + 0.5, 0.5 - at[i + 2]); // v up
  plane.setVerticesData('uv', uv);
  new BABYLON.HemisphericLight('l', BABYLON.Vector3.Up(), scene);
  const camera = new BABYLON.FreeCamera('c', BABYLON.Vector3.Zero(), scene);
  camera.fov = job.fov * Math.PI / 180;
  camera.minZ = 0.05;
  const target = new BABYLON.RenderTargetTexture('t', job.size, scene, false, true, BABYLON.Constants.TEXTURETYPE_FLOAT);
  target.renderList = [plane];
  target.activeCamera = camera;
  target.clearColor = scene.clearColor;

  const draw = async (shot) => {
    const [x, y, z] = h.eye(shot);
    camera.position.set(x, y, z);
    camera.setTarget(BABYLON.Vector3.Zero());
    camera.computeWorldMatrix(true);
    while (!target.isReadyForRendering()) await h.frames(1);
    target.render();
    return target.readPixels();
  };
  const { data, n } = h.ramp();
  const made = [];
  for (const [i, item] of job.materials.entries()) {
    const folder = `/export/${item.folder}/`;
    const module = await import(folder + item.module);
    for (const lit of [true, false]) { // as it is, then as UVs
      const own = module.reliefMaterial(BABYLON, scene, folder);
      if (!lit) own.shaderPath.fragmentSource = h.showingUv(own.shaderPath.fragmentSource);
      plane.material = own;
      await scene.whenReadyAsync();
      if (lit) await draw(job.shots[0]);
      else for (const [j, shot] of job.shots.entries()) await h.send(`own${i * job.shots.length + j}`, await draw(shot), job.size, job.size);
    }
    const m = module.material(BABYLON, scene, folder);
    plane.material = m;
    await scene.whenReadyAsync();
    const broken = m.getActiveTextures().filter((t) => t.loadingError).map((t) => t.url);
    await draw({ pitch: 45, yaw: 20 }); // as it is, lit
    made.push({ depth: m.parallaxScaleBias, parallax: m.useParallax && m.useParallaxOcclusion, textures: m.getActiveTextures().length, broken });
    const ramp = new BABYLON.RawTexture(data, n, n, BABYLON.Constants.TEXTUREFORMAT_RGBA, scene, false, true,
      BABYLON.Texture.BILINEAR_SAMPLINGMODE, BABYLON.Constants.TEXTURETYPE_FLOAT);
    ramp.gammaSpace = false;
    ramp.anisotropicFilteringLevel = 1;
    for (const key of ['uScale', 'vScale', 'uOffset', 'vOffset', 'uRotationCenter', 'vRotationCenter', 'wrapU', 'wrapV']) ramp[key] = m.bumpTexture[key];
    m.albedoTexture = ramp;
    m.albedoColor = BABYLON.Color3.White();
    m.unlit = true;
    for (const [j, shot] of job.shots.entries()) await h.send(`shot${i * job.shots.length + j}`, await draw(shot), job.size, job.size);
  }
  return { version: BABYLON.Engine.Version, made };
}
