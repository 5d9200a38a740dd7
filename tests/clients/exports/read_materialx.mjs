// Reads .mtlx files with MaterialX: read_materialx.mjs FOLDER_OF_NPM FILE.mtlx... Each must validate without a message and give ESSL that reads its pictures.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const [npm, ...files] = process.argv.slice(2);
const bin = path.join(path.resolve(npm), 'node_modules/@needle-tools/materialx/bin');
// The module was built without node's own names.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = bin;
globalThis.__filename = path.join(bin, 'x.js');
const said = [];
const { default: init } = await import(pathToFileURL(path.join(bin, 'JsMaterialXGenShader.js')));
const mx = await init({
  wasmBinary: fs.readFileSync(path.join(bin, 'JsMaterialXGenShader.wasm')),
  locateFile: (name) => path.join(bin, name),
  getPreloadedPackage: () => {
    const data = fs.readFileSync(path.join(bin, 'JsMaterialXGenShader.data.txt'));
    return data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);
  },
  print: (text) => said.push(text),
  printErr: (text) => said.push(text),
});
const why = (error) => typeof error === 'number' && mx.getExceptionMessage ? mx.getExceptionMessage(error) : error?.message ?? String(error);
const generator = mx.EsslShaderGenerator.create ? mx.EsslShaderGenerator.create() : new mx.EsslShaderGenerator();
const context = new mx.GenContext(generator);
const library = mx.loadStandardLibraries(context);

async function read(file) {
  const text = fs.readFileSync(file, 'utf8');
  const faults = [];
  said.length = 0;
  try {
    const document = mx.createDocument();
    await mx.readFromXmlString(document, text, '');
    document.setDataLibrary(library);
    const told = { message: '' };
    if (!document.validate(told) || told.message) faults.push(`validate: ${told.message}`);
    const element = mx.findRenderableElement(document);
    if (!element) throw new Error('nothing to render');
    const shader = generator.generate(element.getName(), element, context);
    const pixel = shader.getSourceCode('pixel');
    for (const [, image] of text.matchAll(/<image name="(?!image_height)(\w+)"/g))
      if (!pixel.includes(`${image}_file`)) faults.push(`the shader does not read ${image}`);
    const displacements = document.getNodes?.().filter?.((node) => node.getCategory() === 'displacement').length;
    const wanted = /image_height/.test(text) ? 1 : 0;
    if (displacements !== undefined && displacements !== wanted) faults.push(`${displacements} displacements`);
  } catch (error) {
    faults.push(why(error));
  }
  faults.push(...said);
  return faults;
}

let failed = 0;
for (const file of files)
  for (const fault of await read(file)) {
    console.log(`${file}: ${fault}`);
    failed += 1;
  }
console.log(`MaterialX ${mx.getVersionString()}: ${files.length} files, ${failed} faults`);
process.exit(failed ? 1 : 0);
