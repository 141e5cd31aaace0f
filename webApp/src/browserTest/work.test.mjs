// Whether work is kept in the browser: opened from a link, there again after a reload and in a page that is opened later, and apart in two tabs.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { startBrowser } from './browser.mjs';
import { isReady, openPage, photograph } from './page.mjs';
import { serve } from './serve.mjs';

let browser;
let site;

before(async () => {
  browser = await startBrowser();
  site = await serve(process.env.PAGE);
});

after(async () => {
  await browser?.close();
  site?.stop();
});

/** All texts that the page has kept, by their names. */
const keptTexts = (page) => page.evaluate(() => new Promise((resolve, reject) => {
  const request = indexedDB.open('robotran', 1);
  request.onerror = () => reject(request.error);
  request.onsuccess = () => {
    const texts = request.result.transaction('texts').objectStore('texts');
    const names = texts.getAllKeys();
    const all = texts.getAll();
    all.onsuccess = () => resolve(Object.fromEntries(names.result.map((name, place) => [name, all.result[place]])));
  };
}));

const works = async (page) => Object.entries(await keptTexts(page)).filter(([name]) => name.startsWith('work-'));

/** Waits until so many works are kept. */
async function keeps(page, count) {
  const end = Date.now() + 20_000;
  while ((await works(page)).length !== count) {
    assert.ok(Date.now() < end, `${(await works(page)).length} works are kept`);
    await page.waitForTimeout(100);
  }
}

test('a link opens its project, which is kept and not opened again by a reload', async () => {
  const text = await readFile(path.join(process.env.EXPECTED_PROJECT_RUNS, 'full-of-things-0.robotran'), 'utf8');
  const fragment = `#p=a${deflateRawSync(JSON.stringify(JSON.parse(text))).toString('base64url')}`;
  const { page, troubles } = await openPage(browser, site, { width: 1280, height: 800 });
  assert.deepEqual(await works(page), [], 'nothing was done, so nothing is kept');
  await page.evaluate((link) => { location.hash = link; }, fragment);
  await keeps(page, 1);
  await photograph(page, 'work-from-link');
  const kept = await works(page);
  assert.match(kept[0][1], /^robotran-work 1\n/);
  assert.equal(await page.evaluate(() => location.hash), '', 'the link is taken out of the address');

  await page.reload();
  await isReady(page);
  await photograph(page, 'work-after-reload');
  assert.equal((await works(page)).length, 1, 'the same work is taken up again');

  const other = await page.context().newPage();
  await other.goto(site.address + fragment);
  await isReady(other);
  await keeps(other, 2); // another tab has a work of its own
  assert.deepEqual(troubles, []);
});
