// three.js with the exported modules: makes each material, tells its numbers, and draws where the vertices of a plane go. See check_web.py.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from 'three';

export async function run(job, canvas, h) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: false });
  renderer.setClearColor(0, 0);
  const n = job.size - 1; // each pixel's centre lies on a vertex, seen from above
  const scene = new THREE.Scene();
  scene.add(new THREE.HemisphereLight());
  const plane = new THREE.Mesh(new THREE.PlaneGeometry(1, 1, n, n).rotateX(-Math.PI / 2));
  scene.add(plane);
  const r = 0.5 + 0.5 / n;
  const camera = new THREE.OrthographicCamera(-r, r, r, -r, 0.1, 20);
  camera.position.set(0, 10, 0);
  camera.up.set(0, 0, -1);
  camera.lookAt(0, 0, 0);
  const target = new THREE.WebGLRenderTarget(job.size, job.size, { type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
  renderer.setRenderTarget(target);
  const draw = () => {
    renderer.clear();
    renderer.render(scene, camera);
    const pixels = new Float32Array(job.size * job.size * 4);
    renderer.readRenderTargetPixels(target, 0, 0, job.size, job.size, pixels);
    return pixels;
  };
  // The same plane undivided, from where the shots stand.
  const flat = new THREE.Mesh(new THREE.PlaneGeometry(1, 1).rotateX(-Math.PI / 2));
  const eye = new THREE.PerspectiveCamera(job.fov, 1, 0.05, 100);
  const seen = new THREE.WebGLRenderTarget(job.own, job.own, { type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
  const own = async (m, i) => {
    flat.material = m;
    for (const j of [-1, ...job.shots.keys()]) { // the first as it is, lit
      if (j === 0) {
        m.fragmentShader = h.showingUv(m.fragmentShader);
        m.needsUpdate = true;
      }
      eye.position.set(...h.eye(job.shots[Math.max(j, 0)]));
      eye.lookAt(0, 0, 0);
      renderer.setRenderTarget(seen);
      renderer.clear();
      renderer.render(flat, eye);
      const pixels = new Float32Array(job.own * job.own * 4);
      renderer.readRenderTargetPixels(seen, 0, 0, job.own, job.own, pixels);
      if (j >= 0) await h.send(`own${i * job.shots.length + j}`, pixels, job.own, job.own);
    }
    renderer.setRenderTarget(target);
  };
  const made = [];
  for (const [i, item] of job.materials.entries()) {
    const folder = `/export/${item.folder}/`;
    const module = await import(folder + item.module);
    await own(await module.reliefMaterial(THREE, folder), i);
    const m = await module.material(THREE, folder);
    plane.material = m;
    draw(); // as it is, lit
    made.push({ depth: m.displacementScale, bias: m.displacementBias, parallax: true, broken: [],
      textures: ['map', 'normalMap', 'displacementMap', 'roughnessMap'].filter((key) => m[key]).length });
    m.onBeforeCompile = (s) => {
      s.vertexShader = s.vertexShader.replace('void main() {', 'varying vec3 vSeen;\nvoid main() {')
        .replace('#include <project_vertex>', '#include <project_vertex>\nvSeen = transformed;');
      s.fragmentShader = s.fragmentShader.replace('void main() {', 'varying vec3 vSeen;\nvoid main() {')
        .replace('#include <dithering_fragment>', '#include <dithering_fragment>\ngl_FragColor = vec4(vSeen, 1.0);');
    };
    m.customProgramCacheKey = () => 'seen';
    m.needsUpdate = true;
    await h.send(`shot${i}`, draw(), job.size, job.size);
  }
  return { version: THREE.REVISION, made };
}
