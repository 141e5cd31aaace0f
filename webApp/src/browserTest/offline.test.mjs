// The app without a network, installed, and updated, from a folder of the server as well.
import assert from 'node:assert/strict';
import { rm } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { startBrowser } from './browser.mjs';
import { openPage } from './page.mjs';
import { serve } from './serve.mjs';
import { anotherVersion } from './versions.mjs';

const SIZE = { width: 1280, height: 800 };
const JAVA = 'public class Nothing {\n    public static void main(String[] args) {\n    }\n}\n';

let browser;

before(async () => { browser = await startBrowser(); });
after(() => browser?.close());

const ready = (page) => page.waitForFunction(() => globalThis.robotran !== undefined, null, { timeout: 60_000 });

/** Waits until the service worker has everything. */
const kept = (page) => page.waitForFunction(
  () => navigator.serviceWorker.getRegistration().then((registration) => registration?.active?.state === 'activated' && !registration.installing),
  null, { timeout: 60_000 });

const runJava = (page) => page.evaluate((text) => globalThis.robotran.run(text, 1000, 'Nothing.java'), JAVA);
const versionOf = (page) => page.evaluate(() => JSON.parse(document.getElementById('site').textContent).version);
const caches = (page) => page.evaluate(() => globalThis.caches.keys());

test('after the first visit the app opens, and compiles Java, without a network', async () => {
  const site = await serve(process.env.PAGE, { under: '/some/school/' });
  const { page, troubles } = await openPage(browser, site, { ...SIZE, keeps: true });
  await kept(page);
  const compilers = site.asked.filter((path) => /\/ecj\.\w+\.wasm$/.test(path));
  assert.equal(compilers.length, 1, 'the compiler is fetched when all else is there');
  assert.ok(site.asked.every((path) => path.startsWith('/some/school/') || path === '/favicon.ico'), 'all lies in the folder');

  site.refuse = () => 503;
  const before = site.asked.length;
  await page.reload();
  await ready(page);
  await runJava(page);
  const other = await page.context().newPage();
  await other.goto(`${site.address}?from=home`);
  await ready(other);
  assert.deepEqual(site.asked.slice(before).filter((path) => !/service-worker\.js$/.test(path)), []);
  assert.deepEqual(troubles.filter((trouble) => !/503/.test(trouble)), []);
  await page.context().close();
  site.stop();
});

test('the app can be installed', async () => {
  const site = await serve(process.env.PAGE);
  const { page } = await openPage(browser, site, { ...SIZE, keeps: true });
  await kept(page);
  const devtools = await page.context().newCDPSession(page);
  const { errors, data, url } = await devtools.send('Page.getAppManifest');
  assert.deepEqual(errors, []);
  assert.deepEqual((await devtools.send('Page.getInstallabilityErrors')).installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== 'in-incognito'), []);
  const manifest = JSON.parse(data);
  for (const { src, sizes } of manifest.icons.filter(({ type }) => type === 'image/png')) {
    const size = await page.evaluate(async (address) => {
      const { width, height } = await createImageBitmap(await (await fetch(address)).blob());
      return `${width}x${height}`;
    }, new URL(src, url).href);
    assert.equal(size, sizes, src);
  }
  await page.context().close();
  site.stop();
});

test('an update waits for the next visit, and what is open goes on with its own version', async () => {
  const site = await serve(process.env.PAGE, { under: '/robotran/' });
  const newer = await anotherVersion(process.env.PAGE);
  const { page, troubles } = await openPage(browser, site, { ...SIZE, keeps: true });
  await kept(page);
  const first = await versionOf(page);

  site.folder = newer;
  await page.evaluate(() => navigator.serviceWorker.getRegistration().then((registration) => registration.update()));
  await page.waitForFunction(() => globalThis.caches.keys().then((names) => names.length === 2), null, { timeout: 60_000 });
  await kept(page);
  const asked = site.asked.length;
  await runJava(page); // the server has this page's compiler no more
  assert.equal(await versionOf(page), first, 'the page was not reloaded');

  const other = await page.context().newPage();
  await other.goto(site.address);
  await ready(other);
  await runJava(other);
  const second = await versionOf(other);
  assert.notEqual(second, first);
  assert.deepEqual(site.asked.slice(asked).filter((path) => !/service-worker\.js$/.test(path)), [], 'both have all they need');
  await other.waitForTimeout(1500);
  assert.equal((await caches(other)).length, 2, 'the older version is kept while a page runs it');

  await page.close();
  await other.reload();
  await other.waitForFunction(() => globalThis.caches.keys().then((names) => names.length === 1), null, { timeout: 30_000 });
  assert.deepEqual(await caches(other), [`robotran /robotran/ ${second}`]);
  assert.deepEqual(troubles, []);
  await other.context().close();
  site.stop();
  await rm(newer, { recursive: true });
});

test('what breaks off half-way is no harm, and is gone on with at the next visit', async () => {
  const site = await serve(process.env.PAGE);
  site.refuse = (path) => (/\/ecj\.\w+\.wasm$/.test(path) ? 503 : null);
  const { page } = await openPage(browser, site, { ...SIZE, keeps: true });
  await page.waitForFunction(() => globalThis.caches.keys().then((names) => names.length === 1), null, { timeout: 30_000 });
  await page.waitForFunction(
    () => navigator.serviceWorker.getRegistration().then((registration) => !registration?.installing && !registration?.active), null, { timeout: 60_000 });

  // A server that has a wrong file does no better than one that has none.
  site.refuse = () => null;
  await page.reload();
  await ready(page);
  const asked = site.asked.length;
  await kept(page);
  assert.deepEqual(site.asked.slice(asked).filter((path) => /skiko|robotran\.\w+\.wasm/.test(path)), [], 'what was kept is not fetched again');
  await page.context().close();
  site.stop();
});
