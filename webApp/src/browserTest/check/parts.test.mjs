// The parts of the app that come after the first picture: late, failing once, failing for ever.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { afterEach, test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { brotliCompressSync, constants } from 'node:zlib';
import { photograph } from '../page.mjs';
import { begin, CHOICES, choicesOn, firstPictureOn, holdRests, laterFiles, PHONE, press, refuseToWait, SCREENS, says } from '../parts.mjs';
import { appIsThere, site, visit } from '../visit.mjs';
import { appears, PATIENCE, reports } from '../words.mjs';

/** How often the page asks for a part before it says that it cannot be fetched: `ATTEMPTS` in `start.js`. */
const ATTEMPTS = 3;

afterEach(() => {
  site.refuse = () => null;
});

firstPictureOn('phone');
choicesOn('phone');

test('whoever touches something else meanwhile means that', async () => {
  const { route, goOn } = holdRests();
  const page = await begin({ ...PHONE, route });
  await press(page, 'try-worlds', PHONE);
  await press(page, 'try-tutorial', PHONE);
  goOn();
  await appears(page, 'tutorial');
  assert.equal(await page.locator('[data-tag="worlds-page"]').count(), 0);
  await page.context().close();
});

test('keys wait for their part, too', async () => {
  const { route, goOn } = holdRests();
  const page = await begin({ ...SCREENS.laptop, route });
  await page.keyboard.press('Escape');
  await says(page, 'One moment: the rest of Robotran is still on its way.');
  goOn();
  await CHOICES['first-run-close'](page);
  await page.context().close();
});

test('a part that does not come is told, the robot draws meanwhile, and trying again brings it', async () => {
  site.refuse = (file) => (/-rest/.test(file) ? 503 : null);
  const page = await begin({ ...PHONE, locale: 'es-MX' });
  const lost = 'No se ha podido traer una parte de Robotran. Quizá no hay red, o la red no la deja pasar.';
  await says(page, lost);
  await photograph(page, 'parts-lost');
  await press(page, 'try-tutorial', PHONE);
  await page.click('#parts button');
  await says(page, lost);
  await press(page, 'try-square', PHONE);
  await reports(page, ({ inkCentimetres }) => inkCentimetres > 1);
  site.refuse = () => null;
  await page.click('#parts button');
  await page.waitForFunction(() => !document.getElementById('parts'), null, { timeout: PATIENCE });
  await page.context().close();
});

test('a part that fails once comes by itself', async () => {
  const failed = new Set();
  site.refuse = (file) => {
    if (!/-rest/.test(file) || failed.has(file)) return null;
    failed.add(file);
    return 503;
  };
  const page = await begin(PHONE);
  await press(page, 'try-tutorial', PHONE);
  await appears(page, 'tutorial');
  assert.equal(failed.size, (await laterFiles(page)).length);
  assert.equal(await page.locator('#parts').count(), 0);
  await page.context().close();
});

test('what was chosen on the greeting and needs a later part is done when that has come', async () => {
  const { route, goOn } = holdRests();
  let begin;
  const chosen = new Promise((resolve) => {
    begin = () => resolve(null);
  });
  site.refuse = (file) => (/robotran\.\w+\.wasm$/.test(file) ? chosen : null);
  const page = await visit({ ...PHONE, route });
  await page.click('[data-wish="worlds"]');
  begin();
  goOn();
  await appIsThere(page);
  await appears(page, 'worlds-page');
  await page.context().close();
});

const runJava = (page) =>
  page.evaluate(() =>
    globalThis.robotran
      .run('public class A { public static void main(String[] a) { } }', 1000, 'A.java')
      .then(({ report }) => JSON.parse(report).status),
  );

test('a call of a function that is not there, such as by a timer, waits for its part', async () => {
  const refused = [];
  site.refuse = (file) => {
    if (!/-rest/.test(file)) return null;
    refused.push(file);
    return 503;
  };
  const page = await begin(PHONE);
  await page.waitForSelector('#parts button', { timeout: PATIENCE });
  // Otherwise a part that the page still asks for would come by itself.
  const isGivenUp = (address) => refused.filter((file) => file.endsWith(address)).length >= ATTEMPTS;
  const later = await laterFiles(page);
  while (!later.every(isGivenUp)) await pause(100);
  site.refuse = () => null;
  assert.equal(await runJava(page), 'ended');
  await page.click('#parts button'); // The other part.
  await page.waitForFunction(() => !document.getElementById('parts'), null, { timeout: PATIENCE });
  await press(page, 'try-tutorial', PHONE);
  await appears(page, 'tutorial');
  await page.context().close();
});

test('a link begins with all parts', async () => {
  const { route, goOn } = holdRests();
  const page = await visit({ ...PHONE, route, address: '#p=a', prepare: refuseToWait });
  await page.waitForFunction(() => document.getElementById('loading-progress').value > 0.3, null, { timeout: PATIENCE });
  assert.equal(await page.evaluate(() => globalThis.robotran), undefined, 'the app waits for its parts');
  goOn();
  await appIsThere(page);
  assert.deepEqual(await page.evaluate(() => globalThis.missing), []);
  assert.equal(await page.locator('#parts').count(), 0);
  await page.context().close();
});

/** How much the first load may grow over the figure in the repository before a change must say why, in bytes. */
const MARGIN = 30_000;

test('the first load is as small as the repository says', async () => {
  const page = await readFile(path.join(process.env.PAGE, 'index.html'));
  const { first } = JSON.parse(/<script type="application\/json" id="site">(.*?)<\/script>/.exec(page)[1]);
  const files = [page, ...(await Promise.all(first.map(([address]) => readFile(path.join(process.env.PAGE, address)))))];
  const smaller = (bytes) =>
    brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 9, [constants.BROTLI_PARAM_LGWIN]: 22 } });
  const now = files.reduce((sum, bytes) => sum + smaller(bytes).length, 0);
  const budget = JSON.parse(await readFile(new URL('../../first-part/budget.json', import.meta.url))).bytes;
  assert.ok(now <= budget + MARGIN, `the first load has ${now} bytes, ${now - budget} more than webApp/src/first-part/budget.json says`);
  assert.ok(now >= budget - 2 * MARGIN, `the first load has only ${now} bytes: say so in webApp/src/first-part/budget.json`);
});
