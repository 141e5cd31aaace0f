// Records the page's calls of the Web Audio API, so tests need no loudspeaker.
import assert from 'node:assert/strict';
import { findColour } from '../browser.mjs';
import { putWelcomeAway, RUN_GREEN } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';

/** Runs in the page: a silent AudioContext that records its tones in `sounds`. */
function listen() {
  const sounds = { contexts: 0, resumed: 0, tones: [] };
  globalThis.sounds = sounds;
  const begin = performance.now();
  const parameter = () => ({
    value: 0,
    setValueAtTime() {
      return this;
    },
    linearRampToValueAtTime() {
      return this;
    },
    cancelScheduledValues() {
      return this;
    },
  });
  const node = (more) => ({ connect: (next) => next, disconnect() {}, ...more });
  globalThis.AudioContext = class {
    constructor() {
      sounds.contexts++;
      this.destination = node({});
      this.state = 'suspended';
    }

    get currentTime() {
      return (performance.now() - begin) / 1000;
    }

    resume() {
      sounds.resumed++;
      this.state = 'running';
      return Promise.resolve();
    }

    close() {
      return Promise.resolve();
    }

    createGain() {
      return node({ gain: parameter() });
    }

    createOscillator() {
      const tone = node({
        type: 'sine',
        frequency: parameter(),
        start: (time) => {
          tone.from = time;
        },
        stop: (time) => {
          tone.until = time;
        },
      });
      sounds.tones.push(tone);
      return tone;
    }
  };
}

const heard = (page) =>
  page.evaluate(() => {
    const { contexts, resumed, tones } = globalThis.sounds;
    return {
      contexts,
      resumed,
      tones: tones.map(({ type, frequency, from, until }) => ({ type, hertz: frequency.value, from, until })),
    };
  });

test('the page makes no sound before it is touched, and the beeps of the brick after', () =>
  onPage({ ...TABLET, prepare: listen, welcome: true }, async ({ page, troubles }) => {
    assert.deepEqual(await heard(page), { contexts: 0, resumed: 0, tones: [] });
    await putWelcomeAway(page);

    const { x, y } = await findColour(page, RUN_GREEN);
    await page.mouse.click(x, y);
    // The square program ends with a beep, and then the brick beeps twice.
    await page.waitForFunction(() => globalThis.sounds.tones.length >= 3, null, { timeout: 60_000 });
    const { contexts, resumed, tones } = await heard(page);
    assert.equal(contexts, 1);
    assert.equal(resumed, 1);
    assert.deepEqual(
      tones.slice(-2).map(({ type, hertz }) => [type, hertz]),
      [
        ['square', 1000],
        ['square', 1000],
      ],
    );
    assert.ok(
      tones.every(({ from, until }) => until > from && until - from < 0.2),
      JSON.stringify(tones),
    );
    const [first, second] = tones.slice(-2);
    assert.ok(
      second.from - first.from > 0.199,
      'the two beeps keep the rhythm of the brick, or a slower one on a slow machine',
    );
    assert.deepEqual(troubles, []);
  }));

test('the browser itself plays the beeps without a complaint', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const { x, y } = await findColour(page, RUN_GREEN);
    await page.mouse.click(x, y);
    await page.waitForFunction(() => JSON.parse(globalThis.robotran.report()).status === 'ended', null, {
      timeout: 60_000,
    });
    await page.waitForTimeout(500);
    assert.deepEqual(troubles, []);
  }));
