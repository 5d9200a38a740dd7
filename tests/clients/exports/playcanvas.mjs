// PlayCanvas with the exported modules: makes each material, tells its numbers, and draws the UVs that the shots fetch. See check_web.py.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import * as pc from 'playcanvas';

export async function run(job, canvas, h) {
  const device = await pc.createGraphicsDevice(canvas, { deviceTypes: [pc.DEVICETYPE_WEBGL2], antialias: false });
  const options = new pc.AppOptions();
  options.graphicsDevice = device;
  options.componentSystems = [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem];
  options.resourceHandlers = [pc.TextureHandler];
  const app = new pc.AppBase(canvas);
  app.init(options);
  app.setCanvasResolution(pc.RESOLUTION_FIXED, job.size, job.size);
  app.autoRender = false; // only what is read is drawn
  app.start();
  const mesh = new pc.Mesh(device); // u along +X, v along +Z: v down
  mesh.setPositions([-0.5, 0, -0.5, 0.5, 0, -0.5, 0.5, 0, 0.5, -0.5, 0, 0.5]);
  mesh.setNormals([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
  mesh.setUvs(0, [0, 0, 1, 0, 1, 1, 0, 1]);
  mesh.setIndices([0, 2, 1, 0, 3, 2]);
  mesh.update();
  const instance = new pc.MeshInstance(mesh, new pc.StandardMaterial());
  const plane = new pc.Entity('plane');
  plane.addComponent('render', { meshInstances: [instance] });
  app.root.addChild(plane);
  const light = new pc.Entity('light');
  light.addComponent('light', { type: 'directional' });
  app.root.addChild(light);
  const colour = new pc.Texture(device, { name: 'target', width: job.size, height: job.size, format: pc.PIXELFORMAT_RGBA32F,
    mipmaps: false, minFilter: pc.FILTER_NEAREST, magFilter: pc.FILTER_NEAREST });
  const target = new pc.RenderTarget({ name: 'target', colorBuffer: colour, depth: true });
  const camera = new pc.Entity('camera');
  camera.addComponent('camera', { fov: job.fov, horizontalFov: false, nearClip: 0.05, farClip: 100, aspectRatio: 1,
    aspectRatioMode: pc.ASPECT_MANUAL, clearColor: new pc.Color(0, 0, 0, 0), renderTarget: target,
    toneMapping: pc.TONEMAP_NONE, gammaCorrection: pc.GAMMA_NONE });
  app.root.addChild(camera);

  const draw = async (shot) => {
    camera.setPosition(...h.eye(shot));
    camera.lookAt(0, 0, 0);
    for (let i = 0; i < 2; ++i) { // the first may still be without a texture
      app.renderNextFrame = true;
      await h.frames(2);
    }
    return colour.read(0, 0, job.size, job.size, { renderTarget: target, immediate: true });
  };
  const { data, n } = h.ramp();
  const made = [];
  for (const [i, item] of job.materials.entries()) {
    const folder = `/export/${item.folder}/`;
    const module = await import(folder + item.module);
    const own = await module.reliefMaterial(pc, app, folder);
    instance.material = own;
    await draw(job.shots[0]); // as it is, lit
    own.shaderDesc = { ...own.shaderDesc, uniqueName: own.shaderDesc.uniqueName + ' UV', fragmentGLSL: h.showingUv(own.shaderDesc.fragmentGLSL) };
    own.update();
    for (const [j, shot] of job.shots.entries()) await h.send(`own${i * job.shots.length + j}`, await draw(shot), job.size, job.size);
    const m = await module.material(pc, app, folder);
    instance.material = m;
    await draw({ pitch: 45, yaw: 20 }); // as it is, lit
    made.push({ depth: m.heightMapFactor / 10, base: m.heightMapBase, parallax: m.parallaxMode === 'occlusion',
      textures: ['diffuseMap', 'normalMap', 'heightMap', 'aoMap', 'glossMap', 'metalnessMap'].filter((key) => m[key]).length, broken: [] });
    const ramp = new pc.Texture(device, { name: 'ramp', width: n, height: n, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false,
      minFilter: pc.FILTER_LINEAR, magFilter: pc.FILTER_LINEAR, addressU: pc.ADDRESS_REPEAT, addressV: pc.ADDRESS_REPEAT, levels: [data] });
    m.useLighting = m.useFog = m.useTonemap = m.useSkybox = false;
    m.diffuseMap = m.aoMap = null;
    m.diffuse = new pc.Color(0, 0, 0);
    m.emissive = new pc.Color(1, 1, 1);
    m.emissiveIntensity = 1;
    m.emissiveMap = ramp;
    for (const key of ['Tiling', 'Offset', 'Rotation']) m['emissiveMap' + key] = m['heightMap' + key];
    m.update();
    for (const [j, shot] of job.shots.entries()) await h.send(`shot${i * job.shots.length + j}`, await draw(shot), job.size, job.size);
  }
  return { version: pc.version, made };
}
