// three.js has no parallax. What can be exported: displacementMap (--mode displacement),
// or a ShaderMaterial with a relief loop of one's own (--mode relief, --glsl FILE).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import * as THREE from 'three';

// The GLSL that FILE replaces: V is the unit vector to the eye in (+u, +v, normal),
// v down; heights are read with texelFetch, so no filtering extension is needed.
const RELIEF = /* glsl */`
float heightAt(sampler2D map, vec2 uv) {
  ivec2 size = textureSize(map, 0);
  vec2 x = uv * vec2(size) - 0.5, f = fract(x);
  ivec2 a = ivec2(floor(x)), i = (a % size + size) % size, j = (i + 1) % size;
  return mix(mix(texelFetch(map, i, 0).r, texelFetch(map, ivec2(j.x, i.y), 0).r, f.x),
             mix(texelFetch(map, ivec2(i.x, j.y), 0).r, texelFetch(map, j, 0).r, f.x), f.y);
}
vec2 relief(sampler2D map, vec2 uv, vec3 V, float depth) {
  vec2 span = -depth * V.xy / max(V.z, 1e-4);
  float low = 0.0, high = 1.0;
  for (int i = 1; i <= 32; i++) {
    float d = float(i) / 32.0;
    if (d >= 1.0 - heightAt(map, uv + span * d)) { high = d; break; }
    low = d;
  }
  for (int i = 0; i < 6; i++) {
    float d = 0.5 * (low + high);
    if (d >= 1.0 - heightAt(map, uv + span * d)) high = d; else low = d;
  }
  return uv + span * high;
}`;

export async function run(job, canvas, h) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: false });
  renderer.setClearColor(0, 0);
  const scene = new THREE.Scene();
  // PlaneGeometry laid down: +Y, u along +X, v up in the image, whose top is at z = -0.5.
  const plane = (n) => new THREE.PlaneGeometry(1, 1, n, n).rotateX(-Math.PI / 2);
  const shoot = async (name, camera, size) => {
    const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    const pixels = new Float32Array(size * size * 4);
    renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
    await h.send(name, pixels, size, size);
  };

  if (job.mode === 'displacement') {
    // Each pixel's centre on a vertex, seen from above; the colour is the displaced position.
    const n = job.segments;
    const map = await new THREE.TextureLoader().loadAsync('/material/height8.png'); // flipY true, NoColorSpace.
    map.wrapS = map.wrapT = THREE.RepeatWrapping;
    const m = new THREE.MeshStandardMaterial({ displacementMap: map, displacementScale: job.scale, displacementBias: job.bias });
    m.onBeforeCompile = (s) => {
      s.vertexShader = s.vertexShader.replace('void main() {', 'varying vec3 vSeen;\nvoid main() {')
        .replace('#include <project_vertex>', '#include <project_vertex>\nvSeen = transformed;');
      s.fragmentShader = s.fragmentShader.replace('void main() {', 'varying vec3 vSeen;\nvoid main() {')
        .replace('#include <dithering_fragment>', '#include <dithering_fragment>\ngl_FragColor = vec4(vSeen, 1.0);');
    };
    scene.add(new THREE.Mesh(plane(n), m));
    const r = 0.5 + 0.5 / n;
    const camera = new THREE.OrthographicCamera(-r, r, r, -r, 0.1, 20);
    camera.position.set(0, 10, 0);
    camera.up.set(0, 0, -1);
    camera.lookAt(0, 0, 0);
    await shoot('shot0', camera, n + 1);
  } else {
    const raw = new Float32Array(await (await fetch('/material/height.f32')).arrayBuffer());
    const map = new THREE.DataTexture(raw, job.heightSize[0], job.heightSize[1], THREE.RedFormat, THREE.FloatType); // R32F, nearest.
    map.needsUpdate = true;
    const code = job.glsl ? await (await fetch('/material/relief.glsl')).text() : RELIEF;
    const m = new THREE.ShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms: { map: { value: map }, depth: { value: job.scale } },
      vertexShader: /* glsl */`out vec2 vUv; out vec3 vEye;
        void main() {
          vUv = vec2(uv.x, 1.0 - uv.y);   // Down, as the picture's rows run in the DataTexture.
          vec4 p = modelMatrix * vec4(position, 1.0);
          vec3 e = cameraPosition - p.xyz;
          vEye = vec3(e.x, e.z, e.y);     // Of this plane: (+u, +v, normal) is (+X, +Z, +Y).
          gl_Position = projectionMatrix * viewMatrix * p;
        }`,
      fragmentShader: /* glsl */`in vec2 vUv; in vec3 vEye; out vec4 colour;
        uniform sampler2D map; uniform float depth;
        ${code}
        void main() { colour = vec4(relief(map, vUv, normalize(vEye), depth), 1.0, 1.0); }`,
    });
    scene.add(new THREE.Mesh(plane(1), m));
    const camera = new THREE.PerspectiveCamera(job.fov, 1, 0.05, 100);
    for (const [i, shot] of job.shots.entries()) {
      camera.position.set(...h.eye(shot));
      camera.lookAt(0, 0, 0);
      await shoot(`shot${i}`, camera, job.size);
    }
  }
  return { version: THREE.REVISION };
}
