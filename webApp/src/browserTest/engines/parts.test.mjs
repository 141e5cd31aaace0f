// The later parts of the app in every engine: late, failing once, failing for ever.
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { photograph, report } from '../page.mjs';
import { appears, PATIENCE, press, reports, words } from '../words.mjs';
import { ENGINES } from './engines.mjs';
import { Visit } from './visit.mjs';

const SIZE = { width: 1180, height: 820 };
const WAITING = 'One moment: the rest of Robotran is still on its way.';
const LOST = 'A part of Robotran could not be fetched. Perhaps the network is away or blocks it.';
const isRest = (file) => /-rest/.test(file);

const until = (page, test, argument) => page.waitForFunction(test, argument, { timeout: PATIENCE });
const says = (page, sentence) => until(page, (wanted) => document.querySelector('#parts p')?.textContent === wanted, sentence);
const isQuiet = (page) => until(page, () => !document.getElementById('parts'));

/** Presses "Try again", and waits until the page has asked again. */
async function tryAgain(page, site) {
  const asked = site.asked.length;
  const [x, y] = await page.evaluate(() => {
    const { left, top, width, height } = document.querySelector('#parts button').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  });
  await page.mouse.click(x, y);
  const end = Date.now() + PATIENCE;
  while (!site.asked.slice(asked).some(isRest) && Date.now() < end) await page.waitForTimeout(100);
}

for (const [name, open] of Object.entries(ENGINES)) {
  describe(`parts in ${name}`, { skip: open === null && `${name} is not here` }, () => {
    let visit;
    /** The first picture of a first visit to a site that answers requests as `refuse` says. */
    const first = (title, refuse, action) =>
      test(title, async (t) => {
        visit = new Visit(() => open(SIZE));
        const begin = async (page, site) => {
          site.refuse = refuse();
          await page.goto(site.address);
          await until(page, () => globalThis.robotran !== undefined && !document.getElementById('loading'));
          await appears(page, 'first-run');
          await action(page, site);
        };
        await visit.step(begin, (text) => t.diagnostic(text)).finally(() => visit.end());
      });

    let goOn;
    const late = () => {
      const held = new Promise((resolve) => {
        goOn = () => resolve(null);
        setTimeout(goOn, PATIENCE); // A page that calls a function of the rest stands still until then.
      });
      return (file) => (isRest(file) ? held : null);
    };

    /** The rest comes so many milliseconds after it is asked for. What an engine calls of it meanwhile waits for it. */
    const LATE = 5_000;
    const comesLate = () => (file) => (isRest(file) ? new Promise((resolve) => setTimeout(() => resolve(null), LATE)) : null);

    first(`while parts are late, the robot draws the square in ${name}`, comesLate, async (page) => {
      await press(page, 'try-square');
      await reports(page, ({ status }) => status === 'ended');
      const { inkCentimetres } = await report(page);
      assert.ok(Math.abs(inkCentimetres - 80) < 2, `a square, but ${inkCentimetres} cm are drawn`);
      assert.equal(await page.locator('#parts').count(), 0, 'nothing is said if nothing was touched in vain');
    });

    first(`a touch in ${name} before its part is there waits for it`, late, async (page) => {
      await press(page, 'try-worlds');
      await says(page, WAITING);
      await photograph(page, `parts-waiting-${name.toLowerCase()}`);
      assert.equal(await words(page, 'worlds-page').count(), 0);
      goOn();
      await appears(page, 'worlds-page');
      await isQuiet(page);
    });

    const failsOnce = () => {
      const failed = new Set();
      return (file) => (isRest(file) && !failed.has(file) ? (failed.add(file), 503) : null);
    };

    first(`a part that fails once in ${name} comes by itself`, failsOnce, async (page) => {
      await press(page, 'try-tutorial');
      await appears(page, 'tutorial');
      await isQuiet(page);
    });

    const fails = () => (file) => (isRest(file) ? 503 : null);

    first(`a part that does not come in ${name} is told, and trying again brings it`, fails, async (page, site) => {
      await says(page, LOST);
      await tryAgain(page, site);
      await says(page, LOST);
      site.refuse = () => null;
      await tryAgain(page, site);
      await isQuiet(page);
    });

    after(() => visit?.end());
  });
}
