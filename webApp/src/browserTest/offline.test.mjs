// The app offline, installed and updated, also in a subfolder of the server.
import assert from 'node:assert/strict';
import { rm } from 'node:fs/promises';
import { after, before } from 'node:test';
import { startBrowser } from './browser.mjs';
import { loadAgain, openPage } from './page.mjs';
import { serve } from './serve.mjs';
import { test } from './tried-again.mjs';
import { anotherVersion } from './versions.mjs';
import { press } from './words.mjs';

const SIZE = { width: 1280, height: 800 };
const JAVA = 'public class Nothing {\n    public static void main(String[] args) {\n    }\n}\n';

let browser;
const sites = [];

before(async () => {
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  for (const site of sites) site.stop();
});

async function newSite(options) {
  const site = await serve(process.env.PAGE, options);
  sites.push(site);
  return site;
}

/** Waits until the function, which may be async, returns true in the page. */
async function until(page, says) {
  const end = Date.now() + 60_000;
  while (!(await page.evaluate(says))) {
    assert.ok(Date.now() < end, `${says} in a minute`);
    await page.waitForTimeout(100);
  }
}

const ready = (page) => page.waitForFunction(() => globalThis.robotran !== undefined, null, { timeout: 60_000 });

/** Waits until the service worker has cached all files. */
const kept = (page) =>
  until(page, () =>
    navigator.serviceWorker
      .getRegistration()
      .then(
        (registration) =>
          registration?.active?.state === 'activated' && !registration.installing && !registration.waiting,
      ),
  );

const runJava = (page) => page.evaluate((text) => globalThis.robotran.run(text, 1000, 'Nothing.java'), JAVA);
const versionOf = (page) => page.evaluate(() => JSON.parse(document.getElementById('site').textContent).version);
const caches = (page) => page.evaluate(() => globalThis.caches.keys());

test('after the first visit the app opens, and compiles Java, without a network', async () => {
  const site = await newSite({ under: '/some/school/' });
  const { page, troubles } = await openPage(browser, site, { ...SIZE, serviceWorkers: 'allow' });
  await kept(page);
  const compilers = site.asked.filter((path) => /\/ecj\.\w+\.wasm$/.test(path));
  assert.equal(compilers.length, 1, 'the compiler is fetched when all else is there');
  assert.equal(
    site.asked.filter((path) => /\/noto_emoji\.\w+\.ttf$/.test(path)).length,
    1,
    'so is the font with emoji',
  );
  assert.ok(
    site.asked.every((path) => path.startsWith('/some/school/') || path === '/favicon.ico'),
    'all lies in the folder',
  );

  site.refuse = () => 503;
  const before = site.asked.length;
  await loadAgain(page);
  await ready(page);
  await runJava(page);
  const font = page.waitForResponse((response) => /\/noto_emoji\./.test(response.url()));
  await press(page, 'program');
  await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
  await page.keyboard.insertText('// 🚀\n');
  assert.equal((await font).status(), 200);
  const other = await page.context().newPage();
  await other.goto(`${site.address}?from=home`);
  await ready(other);
  assert.deepEqual(
    site.asked.slice(before).filter((path) => !/service-worker\.js$/.test(path)),
    [],
  );
  assert.deepEqual(
    troubles.filter((trouble) => !/503/.test(trouble)),
    [],
  );
  await page.context().close();
});

test('the app can be installed', async () => {
  const site = await newSite();
  const { page } = await openPage(browser, site, { ...SIZE, serviceWorkers: 'allow' });
  await kept(page);
  const devtools = await page.context().newCDPSession(page);
  const { errors, data, url } = await devtools.send('Page.getAppManifest');
  assert.deepEqual(errors, []);
  assert.deepEqual(
    (await devtools.send('Page.getInstallabilityErrors')).installabilityErrors
      .map(({ errorId }) => errorId)
      .filter((id) => id !== 'in-incognito'),
    [],
  );
  const manifest = JSON.parse(data);
  for (const { src, sizes } of manifest.icons.filter(({ type }) => type === 'image/png')) {
    const size = await page.evaluate(async (address) => {
      const { width, height } = await createImageBitmap(await (await fetch(address)).blob());
      return `${width}x${height}`;
    }, new URL(src, url).href);
    assert.equal(size, sizes, src);
  }
  await page.context().close();
});

test('an update waits for the next visit, and what is open goes on with its own version', async () => {
  const site = await newSite({ under: '/robotran/' });
  const newer = await anotherVersion(process.env.PAGE);
  const { page, troubles } = await openPage(browser, site, { ...SIZE, serviceWorkers: 'allow' });
  await kept(page);
  const first = await versionOf(page);

  site.folder = newer;
  await page.evaluate(() => navigator.serviceWorker.getRegistration().then((registration) => registration.update()));
  await until(page, () => globalThis.caches.keys().then((names) => names.length === 2));
  await kept(page);
  const asked = site.asked.length;
  await runJava(page); // the server no longer has this page's compiler
  assert.equal(await versionOf(page), first, 'the page was not reloaded');

  const other = await page.context().newPage();
  await other.goto(site.address);
  await ready(other);
  await runJava(other);
  const second = await versionOf(other);
  assert.notEqual(second, first);
  assert.deepEqual(
    site.asked.slice(asked).filter((path) => !/service-worker\.js$/.test(path)),
    [],
    'both have all they need',
  );
  await other.waitForTimeout(1500);
  assert.equal((await caches(other)).length, 2, 'the older version is kept while a page runs it');

  await page.close();
  await loadAgain(other);
  await until(other, () => globalThis.caches.keys().then((names) => names.length === 1));
  assert.deepEqual(await caches(other), [`robotran /robotran/ ${second}`]);
  assert.deepEqual(troubles, []);
  await other.context().close();
  await rm(newer, { recursive: true });
});

test('what breaks off half-way is no harm, and is gone on with at the next visit', async () => {
  const site = await newSite();
  site.refuse = (path) => (path.endsWith('.webmanifest') ? 503 : null); // nearly the last
  const { page } = await openPage(browser, site, { ...SIZE, serviceWorkers: 'allow' });
  await until(page, () => globalThis.caches.keys().then((names) => names.length === 1));
  await until(page, () => navigator.serviceWorker.getRegistration().then((registration) => !registration));

  site.refuse = () => null;
  const asked = site.asked.length;
  await loadAgain(page);
  await ready(page);
  await kept(page);
  assert.ok(
    site.asked.slice(asked).filter((path) => /skiko/.test(path)).length <= 1,
    'the page may have asked for it, the service worker has it',
  );
  await page.context().close();
});
