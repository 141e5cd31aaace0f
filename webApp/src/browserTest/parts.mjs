// The parts of the app that come after the first picture, while they are held back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photograph, report } from './page.mjs';
import { appIsThere, visit } from './visit.mjs';
import { appears, PATIENCE, placeOf } from './words.mjs';

const FINGER = { hasTouch: true, isMobile: true };
export const PHONE = { viewport: { width: 411, height: 891 }, ...FINGER };
export const SCREENS = { phone: PHONE, tablet: { viewport: { width: 1180, height: 820 }, ...FINGER }, laptop: { viewport: { width: 1280, height: 800 } } };
const RESTS = '**/files/*-rest*.wasm';

/** The files that come after the first picture, as the page names them. */
export const laterFiles = (page) => page.evaluate(() => JSON.parse(document.getElementById('site').textContent).rests.flat().map(([address]) => address));

/** Runs in the page: a request that the page waits for shows that a function is called whose part is not there. */
export function refuseToWait() {
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
export function holdRests() {
  let goOn;
  const held = new Promise((resolve) => {
    goOn = resolve;
  });
  const isWaitedFor = (route) => route.request().resourceType() === 'xhr';
  return { route: [RESTS, (route) => (isWaitedFor(route) ? route.continue() : held.then(() => route.continue()).catch(() => undefined))], goOn };
}

/** Presses what has the test tag `tag` once, with a finger or the mouse. */
export async function press(page, tag, { hasTouch }) {
  const { x, y } = await placeOf(page, tag);
  await (hasTouch ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
}

/** The first picture stands, while the later parts are on their way. */
export async function begin(options) {
  const page = await visit(options);
  await appIsThere(page);
  await appears(page, 'first-run');
  return page;
}

export const says = (page, sentence) =>
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

/** Declares the test that the first picture and the square on the screen `name` need no later part. */
export const firstPictureOn = (name) =>
  test(`the first picture and the square that is drawn need no later part (${name})`, async () => {
    let missing = [];
    for (let visits = 0; visits < VISITS; visits++) {
      missing = await missingOn(SCREENS[name], name === 'phone' ? 'de-AT' : 'en-GB');
      if (missing.length === 0) return;
      console.log(`${name}: called of a later part: ${missing[0]}`);
    }
    assert.deepEqual(missing, [], 'record again: ./gradlew :webApp:recordFirstPart');
  });

// Each choice of the first picture, and what shows that it has been carried out.
export const CHOICES = {
  'try-tutorial': (page) => appears(page, 'tutorial'),
  'try-worlds': (page) => appears(page, 'worlds-page'),
  'try-lessons': (page) => appears(page, 'map-page'),
  'try-robot': (page) => appears(page, 'robot-spike-prime'),
  'try-teachers': (page) => appears(page, 'teachers-page'),
  'first-run-close': (page) => page.waitForFunction(() => !document.querySelector('[data-tag="first-run"]'), null, { timeout: PATIENCE }),
};

/** Declares the tests that each choice on the screen `name` waits for its part. */
export function choicesOn(name) {
  const screen = SCREENS[name];
  // On a low screen all lessons are found in the menu.
  const choices = Object.entries(CHOICES).filter(([tag]) => name !== 'phone' || tag !== 'try-lessons');
  for (const [tag, isDone] of choices)
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
}
