// The parts of the app that come after the first picture: late, failing once, failing for ever.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { afterEach, test } from 'node:test';
import { brotliCompressSync, constants } from 'node:zlib';
import { photograph, report } from '../page.mjs';
import { appIsThere, site, visit } from '../visit.mjs';
import { appears, PATIENCE, placeOf, reports } from '../words.mjs';

const FINGER = { hasTouch: true, isMobile: true };
const PHONE = { viewport: { width: 411, height: 891 }, ...FINGER };
const SCREENS = { phone: PHONE, tablet: { viewport: { width: 1180, height: 820 }, ...FINGER }, laptop: { viewport: { width: 1280, height: 800 } } };
const RESTS = '**/files/*-rest.*.wasm';

/** Runs in the page: a request that the page waits for shows that a function is called whose part is not there. */
function refuseToWait() {
  globalThis.missing = [];
  XMLHttpRequest.prototype.open = () => {
    const error = new Error('a function of a later part is called');
    globalThis.missing.push(error.stack);
    throw error;
  };
}

/**
 * Holds the later parts back until the returned function is called. A request for which the page stands still, see
 * `joinAtOnce` in `parts.js`, is answered.
 */
function holdRests() {
  let goOn;
  const held = new Promise((resolve) => {
    goOn = resolve;
  });
  const isWaitedFor = (route) => route.request().resourceType() === 'xhr';
  return { route: [RESTS, (route) => (isWaitedFor(route) ? route.continue() : held.then(() => route.continue()).catch(() => undefined))], goOn };
}

/** Presses what has the test tag `tag` once, with a finger or the mouse. */
async function press(page, tag, { hasTouch }) {
  const { x, y } = await placeOf(page, tag);
  await (hasTouch ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
}

afterEach(() => {
  site.refuse = () => null;
});

/** The first picture stands, while the later parts are on their way. */
async function begin(options) {
  const page = await visit(options);
  await appIsThere(page);
  await appears(page, 'first-run');
  return page;
}

const says = (page, sentence) =>
  page.waitForFunction((wanted) => document.querySelector('#parts p')?.textContent === wanted, sentence, { timeout: PATIENCE });

/** The functions of later parts that the first picture and the square call on `screen`. */
async function missingOn(screen, locale) {
  const { route, goOn } = holdRests();
  const page = await begin({ ...screen, route, prepare: refuseToWait, locale });
  for (const tag of await page.evaluate(() => globalThis.robotranPage.atOnce)) await press(page, tag, screen);
  await page.waitForFunction(
    () => globalThis.missing.length > 0 || JSON.parse(globalThis.robotran.report()).status === 'ended',
    null,
    { timeout: PATIENCE },
  );
  const missing = await page.evaluate(() => globalThis.missing);
  if (missing.length === 0) {
    const { inkCentimetres } = await report(page);
    assert.ok(Math.abs(inkCentimetres - 80) < 2, `a square, but ${inkCentimetres} cm are drawn`);
    assert.equal(await page.locator('#parts').count(), 0, 'nothing is said if nothing was touched in vain');
  }
  goOn();
  await page.context().close();
  return missing;
}

/** Time decides some of what is called, but what a list lacks that has gone stale is called at each visit. */
const VISITS = 3;

for (const [name, screen] of Object.entries(SCREENS))
  test(`the first picture and the square that is drawn need no later part (${name})`, async () => {
    let missing = [];
    for (let visits = 0; visits < VISITS; visits++) {
      missing = await missingOn(screen, name === 'phone' ? 'de-AT' : 'en-GB');
      if (missing.length === 0) return;
      console.log(`${name}: called of a later part: ${missing[0]}`);
    }
    assert.deepEqual(missing, [], 'record again: ./gradlew :webApp:recordFirstPart');
  });

// Each choice of the first picture, and what shows that it has been carried out.
const CHOICES = {
  'try-tutorial': (page) => appears(page, 'tutorial'),
  'try-worlds': (page) => appears(page, 'worlds-page'),
  'try-lessons': (page) => appears(page, 'map-page'),
  'first-run-close': (page) => page.waitForFunction(() => !document.querySelector('[data-tag="first-run"]'), null, { timeout: PATIENCE }),
};

for (const [tag, isDone] of Object.entries(CHOICES))
  for (const [name, screen] of Object.entries({ phone: SCREENS.phone, laptop: SCREENS.laptop }))
    test(`${tag} is touched before its part is there: the page says so, lives on, and does it then (${name})`, async () => {
      const { route, goOn } = holdRests();
      const page = await begin({ ...screen, route, locale: 'de-AT' });
      await press(page, tag, screen);
      await says(page, 'Einen Moment: Der Rest von Robotran ist noch unterwegs.');
      await photograph(page, `parts-waiting-${name}`);
      assert.equal(await page.locator('[data-tag="first-run"]').count(), 1, 'nothing has been done yet');
      goOn();
      await isDone(page);
      assert.equal(await page.locator('#parts').count(), 0);
      await page.context().close();
    });

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
  assert.equal(failed.size, 2);
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
  site.refuse = (file) => (/-rest/.test(file) ? 503 : null);
  const page = await begin(PHONE);
  await page.waitForSelector('#parts button', { timeout: PATIENCE });
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
