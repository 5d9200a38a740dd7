// PlayCanvas: StandardMaterial with heightMap (2.22 or later for parallaxMode).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import * as pc from 'playcanvas';

export async function run(job, canvas, h) {
  const device = await pc.createGraphicsDevice(canvas, { deviceTypes: [pc.DEVICETYPE_WEBGL2], antialias: false });
  const options = new pc.AppOptions();
  options.graphicsDevice = device;
  options.componentSystems = [pc.RenderComponentSystem, pc.CameraComponentSystem];
  options.resourceHandlers = [pc.TextureHandler];
  const app = new pc.AppBase(canvas);
  app.init(options);
  app.setCanvasResolution(pc.RESOLUTION_FIXED, job.size, job.size);
  app.start();

  const height = await new Promise((done, fail) => {
    const asset = new pc.Asset('height', 'texture', { url: '/material/height8.png' }, { mipmaps: job.mips });
    asset.once('load', () => done(asset.resource));
    asset.once('error', (message) => fail(new Error(message)));
    app.assets.add(asset);
    app.assets.load(asset);
  });
  height.anisotropy = 1;
  height.minFilter = job.mips ? pc.FILTER_LINEAR_MIPMAP_LINEAR : pc.FILTER_LINEAR;

  const { data, n } = h.ramp();
  const ramp = new pc.Texture(device, { name: 'ramp', width: n, height: n, format: pc.PIXELFORMAT_RGBA32F,
    mipmaps: false, minFilter: pc.FILTER_LINEAR, magFilter: pc.FILTER_LINEAR,
    addressU: pc.ADDRESS_REPEAT, addressV: pc.ADDRESS_REPEAT, levels: [data] });

  const m = new pc.StandardMaterial();
  m.useLighting = false;
  m.useFog = false;
  m.useTonemap = false;
  m.useSkybox = false;
  m.diffuse = new pc.Color(0, 0, 0);
  m.emissive = new pc.Color(1, 1, 1);
  m.emissiveMap = ramp;
  if (job.mode !== 'off') {
    m.heightMap = height;
    m.heightMapChannel = 'r';
    m.heightMapFactor = job.factor;
    m.heightMapBase = job.base;
    m.parallaxMode = job.mode;        // 'offset' | 'occlusion'
    m.parallaxSamples = job.samples;
  }
  m.update();

  // u along +X, v along +Z, v down: PlayCanvas has top-left UVs as glTF has.
  const mesh = new pc.Mesh(device);
  mesh.setPositions([-0.5, 0, -0.5, 0.5, 0, -0.5, 0.5, 0, 0.5, -0.5, 0, 0.5]);
  mesh.setNormals([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
  mesh.setUvs(0, [0, 0, 1, 0, 1, 1, 0, 1]);
  // glTF's rule: cross(+Y, +X) = -Z is image up, so w = 1.
  if (job.tangents) mesh.setVertexStream(pc.SEMANTIC_TANGENT, [1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1], 4);
  mesh.setIndices([0, 2, 1, 0, 3, 2]);
  mesh.update();
  const plane = new pc.Entity('plane');
  plane.addComponent('render', { meshInstances: [new pc.MeshInstance(mesh, m)] });
  app.root.addChild(plane);

  const colour = new pc.Texture(device, { name: 'target', width: job.size, height: job.size, format: pc.PIXELFORMAT_RGBA32F,
    mipmaps: false, minFilter: pc.FILTER_NEAREST, magFilter: pc.FILTER_NEAREST });
  const target = new pc.RenderTarget({ name: 'target', colorBuffer: colour, depth: true });
  const camera = new pc.Entity('camera');
  camera.addComponent('camera', { fov: job.fov, horizontalFov: false, nearClip: 0.05, farClip: 100, aspectRatio: 1,
    aspectRatioMode: pc.ASPECT_MANUAL, clearColor: new pc.Color(0, 0, 0, 0), renderTarget: target,
    toneMapping: pc.TONEMAP_NONE, gammaCorrection: pc.GAMMA_NONE });
  app.root.addChild(camera);
  for (const [i, shot] of job.shots.entries()) {
    camera.setPosition(...h.eye(shot));
    camera.lookAt(0, 0, 0);
    await h.frames(4);
    const pixels = await colour.read(0, 0, job.size, job.size, { renderTarget: target, immediate: true });
    await h.send(`shot${i}`, pixels, job.size, job.size);
  }
  return { version: pc.version };
}
