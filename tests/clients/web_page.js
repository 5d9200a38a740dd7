// Opens exported pages from disk in headless Chromium: node web_page.js SIZE PAGE.html...; beside each page PAGE_a.png and PAGE_b.png, the
// pictures of both techniques, and PAGE_page.png as a visitor sees it. Fails on a console message, a request, or controls without effect.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
const puppeteer = require('puppeteer-core');
const path = require('path');

const size = Number(process.argv[2]);
const failures = [];
function check(isRight, what) {
  if (!isRight) failures.push(what);
}

async function settled(page, drawn) {
  await page.waitForFunction((text) => document.body.dataset.drawn === text || !document.getElementById('error').hidden,
    {timeout: 120000}, drawn);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
const picture = async (page) => Buffer.from(await page.screenshot()).toString('base64');

async function dragged(page, key, selector, at) {
  const from = await page.evaluate((name, at) => {
    const box = document.querySelector(name).getBoundingClientRect();
    return {x: box.x + box.width * at, y: box.y + box.height / 3};
  }, selector, at);
  if (key) await page.keyboard.down(key);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 60, from.y + 20, {steps: 2});
  await page.mouse.up();
  if (key) await page.keyboard.up(key);
}

async function tryControls(page, name) {
  let before = await picture(page);
  const changes = async (what, act) => {
    await act();
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const after = await picture(page);
    check(after !== before, `${name}: ${what} changes nothing`);
    before = after;
  };
  await changes('a drag', () => dragged(page, null, '#canvas', 0.2));
  await changes('Shift and a drag', () => dragged(page, 'Shift', '#canvas', 0.2));
  await changes('the divider', () => dragged(page, null, '#wipe', 0.5));
  await changes('the wheel', () => page.mouse.wheel({deltaY: 300}));
}

async function open(browser, file) {
  const page = await browser.newPage(), name = path.basename(file), stem = file.replace(/\.html$/, '');
  page.on('console', (message) => check(false, `${name}: the console says ${message.text()}`));
  page.on('pageerror', (error) => check(false, `${name}: ${error.message}`));
  page.on('request', (request) => check(/^(file|data|blob):/.test(request.url()), `${name} asks for ${request.url()}`));
  await page.setViewport({width: size, height: size});
  await page.goto('file://' + path.resolve(file));
  await page.waitForFunction(() => document.body.dataset.drawn || !document.getElementById('error').hidden, {timeout: 120000});
  const error = await page.evaluate(() => document.getElementById('error').textContent);
  check(error === '', `${name}: ${error}`);
  if (error === '') {
    const both = await page.evaluate(() => document.body.dataset.drawn);
    await page.screenshot({path: stem + '_page.png'});
    for (const [i, id] of ['a', 'b'].entries()) {
      await page.click('#' + id);
      await settled(page, both.split(' | ')[i]);
      await page.evaluate(() => { document.getElementById('ui').style.visibility = 'hidden'; });
      await page.screenshot({path: `${stem}_${id}.png`});
      await page.evaluate(() => { document.getElementById('ui').style.visibility = ''; });
    }
    await page.click('#both');
    await settled(page, both);
    await tryControls(page, name);
    await page.setViewport({width: 360, height: 640, deviceScaleFactor: 2});
    await page.screenshot({path: stem + '_phone.png'});
    check(await page.evaluate(() => document.getElementById('canvas').width === 720), `${name}: pixels of the screen are not used`);
  }
  await page.close();
}

(async () => {
  const browser = await puppeteer.launch({executablePath: process.env.CHROMIUM || '/usr/bin/chromium', headless: true,
    protocolTimeout: 600000, args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader', '--force-color-profile=srgb']});
  for (const file of process.argv.slice(3)) await open(browser, file);
  await browser.close();
  for (const failure of failures) console.error(failure);
  process.exit(failures.length === 0 ? 0 : 1);
})();
