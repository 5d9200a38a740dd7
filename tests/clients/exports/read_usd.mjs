// Reads exported .usda files with tinyusdz, laid on a plane: read_usd.mjs FOLDER_OF_NPM FILE.usda...
// The material must arrive with each texture that the text connects.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [npm, ...files] = process.argv.slice(2);
const folder = path.join(path.resolve(npm), 'node_modules/tinyusdz');
const version = JSON.parse(fs.readFileSync(path.join(folder, 'package.json'))).version;
// It is built for browsers only: looks like one.
globalThis.window = globalThis;
process.type = 'renderer';
const { default: init } = await import(pathToFileURL(path.join(folder, 'tinyusdz.js')));
const said = [];
const usd = await init({
  instantiateWasm: (imports, done) => {
    WebAssembly.instantiate(fs.readFileSync(path.join(folder, 'tinyusdz.wasm')), imports).then((made) => done(made.instance));
    return {};
  },
  print: (text) => said.push(text),
  printErr: (text) => said.push(text),
});

const plane = (material) => `
def Mesh "Plane" (prepend apiSchemas = ["MaterialBindingAPI"])
{
    rel material:binding = </${material}>
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = "vertex")
}
`;
let failed = 0;
for (const file of files) {
  const text = fs.readFileSync(file, 'utf8');
  const fail = (why) => { console.log(`${file}: ${why}`); failed += 1; };
  const name = /defaultPrim = "(.*)"/.exec(text)[1];
  const alone = new usd.TinyUSDZLoaderNative();
  if (!alone.loadAsLayerFromBinary(Buffer.from(text), file)) { fail(`not read: ${alone.error()}`); continue; }
  const scene = new usd.TinyUSDZLoaderNative();
  // Pictures are not decoded: what is read is the text.
  for (const picture of text.matchAll(/@(.*?)@/g)) {
    if (!fs.existsSync(path.join(path.dirname(file), picture[1]))) fail(`there is no ${picture[1]}`);
    scene.setAsset?.(picture[1], fs.readFileSync(path.join(path.dirname(file), picture[1])));
  }
  if (!scene.loadFromBinary(Buffer.from(text + plane(name)), file)) { fail(`laid on a plane: ${scene.error()}`); continue; }
  const material = scene.getMaterial(0);
  const layer = alone.layerToString();
  for (const [, input] of text.matchAll(/inputs:(\w+)\.connect = <.*\.outputs:(?:rgb|r|a)>/g))
    // The displacement is no part of what a material tells; the layer holds it.
    if (input === 'displacement' ? !/inputs:displacement\.connect = <.*\/Height\.outputs:r>/.test(layer) : material[`${input}TextureId`] === undefined)
      fail(`${input} arrives without its texture`);
}
console.log(`tinyusdz ${version}: ${files.length} files, ${failed} faults`);
process.exit(failed ? 1 : 0);
