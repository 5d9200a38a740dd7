// Serves page, engine and material on 127.0.0.1, opens them in headless Chromium
// (WebGL 2 through SwiftShader) and writes what the page hands back.
//
//   node drive.mjs CACHE JOB.json OUT_DIR [TIMEOUT_S]
//
// Writes OUT_DIR/<shot>.f32 (float RGBA, top row first), report.json, console.txt.
// Exit status 0 fine, 1 the engine complained (console errors), 2 no result.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { createRequire } from 'node:module';

const [cache, jobFile, out, limit = '120'] = process.argv.slice(2);
const puppeteer = createRequire(path.resolve(cache) + '/')('puppeteer-core');
const here = path.dirname(new URL(import.meta.url).pathname);
const job = JSON.parse(fs.readFileSync(jobFile));
const lib = path.join(cache, 'node_modules',
  { babylon: 'babylonjs', playcanvas: 'playcanvas/build', three: 'three/build' }[job.engine]);

const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.png': 'image/png', '.json': 'application/json' };
const server = http.createServer((request, reply) => {
  const url = request.url.split('?')[0];
  const name = path.basename(url);
  if (request.method === 'POST' && url.startsWith('/result/')) {
    request.pipe(fs.createWriteStream(path.join(out, name + '.f32'))).on('close', () => reply.writeHead(204).end());
    return;
  }
  const file = url === '/' ? path.join(here, 'page.html')
    : url === '/job.json' ? jobFile
    : url === '/adapter.mjs' ? job.adapter ?? path.join(here, job.engine + '.mjs')
    : url.startsWith('/export/') && job.exports ? path.join(job.exports, path.normalize(decodeURIComponent(url.slice(8))))
    : url.startsWith('/lib/') ? path.join(lib, name)
    : url.startsWith('/material/') ? path.join(out, name) : '';
  if (name === 'favicon.ico') { reply.writeHead(204).end(); return; }
  if (!file || !fs.existsSync(file)) { reply.writeHead(404).end(); return; }
  reply.writeHead(200, { 'Content-Type': types[path.extname(file)] ?? 'application/octet-stream' });
  fs.createReadStream(file).pipe(reply);
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));

const started = Date.now();
const log = fs.createWriteStream(path.join(out, 'console.txt'));
const errors = [];
const note = (kind, text) => {
  const line = `${((Date.now() - started) / 1000).toFixed(1)} ${kind} ${text}`;
  log.write(line + '\n');
  if (process.env.WEBENGINES_VERBOSE) console.error(line);
  if (kind === 'error') errors.push(text);
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
  page.on('console', (m) => note(m.type(), m.text()));
  page.on('pageerror', (e) => note('error', e.message));
  const end = new Promise((done, fail) => {
    setTimeout(() => fail(new Error(`no end after ${limit} s`)), Number(limit) * 1000).unref();
    page.exposeFunction('harnessEnd', done);
    page.exposeFunction('harnessFail', (text) => fail(new Error(text)));
    page.on('error', fail);
  });
  await page.goto(`http://127.0.0.1:${server.address().port}/`, { timeout: 120000 });
  const report = { ...JSON.parse(await end), errors, seconds: (Date.now() - started) / 1000 };
  fs.writeFileSync(path.join(out, 'report.json'), JSON.stringify(report, null, 1));
  status = errors.length ? 1 : 0;
} catch (error) {
  note('error', String(error));
}
for (const text of errors) console.error('ENGINE: ' + text.slice(0, 2000));
await browser.close();
server.close();
log.end();
process.exitCode = status;
