// The app installed and updated, and a first visit that breaks off.
import assert from 'node:assert/strict';
import { rm } from 'node:fs/promises';
import { test } from 'node:test';
import { isKeptOffline, isThere, newSite, openKept, runJava, until } from '../offline.mjs';
import { loadAgain } from '../page.mjs';
import { anotherVersion } from '../versions.mjs';

const versionOf = (page) => page.evaluate(() => JSON.parse(document.getElementById('site').textContent).version);
const cachesOf = (page) => page.evaluate(() => globalThis.caches.keys());

test('the app can be installed', async () => {
  const site = await newSite();
  const { page } = await openKept(site);
  await isKeptOffline(page);
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
  const { page, troubles } = await openKept(site);
  await isKeptOffline(page);
  const first = await versionOf(page);

  site.folder = newer;
  await page.evaluate(() => navigator.serviceWorker.getRegistration().then((registration) => registration.update()));
  await until(page, () => globalThis.caches.keys().then((names) => names.length === 2));
  await isKeptOffline(page);
  const asked = site.asked.length;
  await runJava(page); // the server no longer has this page's compiler
  assert.equal(await versionOf(page), first, 'the page was not reloaded');

  const other = await page.context().newPage();
  await other.goto(site.address);
  await isThere(other);
  await runJava(other);
  const second = await versionOf(other);
  assert.notEqual(second, first);
  assert.deepEqual(
    site.asked.slice(asked).filter((path) => !/service-worker\.js$/.test(path)),
    [],
    'both have all they need',
  );
  await loadAgain(other);
  await isThere(other);
  await runJava(other);
  assert.equal((await cachesOf(other)).length, 2, 'the older version is kept while a page runs it');

  await page.close();
  await loadAgain(other);
  await until(other, () => globalThis.caches.keys().then((names) => names.length === 1));
  assert.deepEqual(await cachesOf(other), [`robotran /robotran/ ${second}`]);
  assert.deepEqual(troubles, []);
  await other.context().close();
  await rm(newer, { recursive: true });
});

test('what breaks off half-way is no harm, and is gone on with at the next visit', async () => {
  const site = await newSite();
  site.refuse = (path) => (path.endsWith('.webmanifest') ? 503 : null); // nearly the last
  const { page } = await openKept(site);
  await until(page, () => globalThis.caches.keys().then((names) => names.length === 1));
  await until(page, () => navigator.serviceWorker.getRegistration().then((registration) => !registration));

  site.refuse = () => null;
  const asked = site.asked.length;
  await loadAgain(page);
  await isThere(page);
  await isKeptOffline(page);
  assert.ok(
    site.asked.slice(asked).filter((path) => /skiko/.test(path)).length <= 1,
    'the page may have asked for it, the service worker has it',
  );
  await page.context().close();
});
