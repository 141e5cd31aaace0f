// Records the page's calls of the Web Audio API, so tests need no loudspeaker.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { putWelcomeAway } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { press, reports, writeProgram } from '../words.mjs';

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

    await press(page, 'brick-run');
    // The square program ends with a beep, and then the brick beeps twice.
    await page.waitForFunction(() => globalThis.sounds.tones.length >= 3);
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

/** Runs in the page: counts the tones that have begun and ended. */
function countTones() {
  const { start } = OscillatorNode.prototype;
  globalThis.tones = { begun: 0, ended: 0 };
  OscillatorNode.prototype.start = function (...values) {
    globalThis.tones.begun += 1;
    this.addEventListener('ended', () => (globalThis.tones.ended += 1));
    start.apply(this, values);
  };
}

test('the browser itself plays the beeps without a complaint', () =>
  onPage({ ...TABLET, prepare: countTones }, async ({ page, troubles }) => {
    await writeProgram(page, 'beep');
    await press(page, 'run');
    await reports(page, (report) => report.status === 'ended');
    await page.waitForFunction(() => globalThis.tones.begun >= 3 && globalThis.tones.ended === globalThis.tones.begun);
    assert.deepEqual(troubles, []);
  }));
