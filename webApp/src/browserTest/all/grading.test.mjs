// Hand-ins of a class with an NXT, a page without workers, workers that die, never answer or do not start, and grading that is stopped.
import assert from 'node:assert/strict';
import { costsItsRow, expected, grade, haveEnded, isGraded, NXT, RCX, table } from '../grading.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, press } from '../words.mjs';

// The workers compile Java for leJOS NXJ: they fetch its class library themselves.
test('workers give a class with an NXT the same grades as the JVM', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const workers = [];
    page.on('worker', (worker) => workers.push(worker));
    await grade(page, NXT);
    await isGraded(page);
    assert.equal(await table(page), await expected(NXT));
    assert.ok(workers.length >= 1, `${workers.length} workers`);
    await haveEnded(page);
    assert.deepEqual(troubles, []);
  }));

for (const [robots, handIns] of [
  ['an RCX', RCX],
  ['an NXT', NXT],
]) {
  test(`without workers, the page grades a class with ${robots} in slices, with the same result`, () =>
    onPage({ ...TABLET, prepare: () => delete globalThis.Worker }, async ({ page, troubles }) => {
      await grade(page, handIns);
      await isGraded(page);
      assert.equal(await table(page), await expected(handIns));
      assert.deepEqual(troubles, []);
    }));
}

test('a worker that stands still costs its own row only', () => costsItsRow(standsStill));

/** Runs in the page: the worker of the second hand-in never answers, and the page waits for seconds instead of minutes. */
function standsStill() {
  let handIns = 0;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message) {
    if (typeof message !== 'string' || message.includes('"first"') || (handIns += 1) !== 2) postMessage.call(this, message);
  };
  const wait = globalThis.setTimeout;
  globalThis.setTimeout = (action, time, ...more) => wait(action, time === 5_000 ? 500 : time, ...more);
}

test('a worker that dies costs its own row only', () => costsItsRow(dies));

/** Runs in the page: the worker of the second hand-in ends with an error. */
function dies() {
  let handIns = 0;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message) {
    // Only orders have a first seed.
    if (typeof message === 'string' && !message.includes('"first"') && (handIns += 1) === 2) {
      this.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
    } else postMessage.call(this, message);
  };
}

test('a worker that does not start the first time costs no row', () =>
  onPage({ ...TABLET, prepare: startsOnlyOnce }, async ({ page, troubles }) => {
    await grade(page);
    await isGraded(page);
    assert.equal(await table(page), await expected());
    assert.ok(await page.evaluate(() => globalThis.hasFailed), 'a worker has failed');
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: what the second worker needs does not come. */
function startsOnlyOnce() {
  const Original = Worker;
  let workers = 0;
  globalThis.Worker = function Worker(address, options) {
    if (!/ecj-worker/.test(address) && (workers += 1) === 2) {
      globalThis.hasFailed = true;
      const failing = { postMessage: () => undefined, terminate: () => undefined };
      setTimeout(() => failing.onerror({ preventDefault: () => undefined, message: 'could not be fetched' }));
      return failing;
    }
    return new Original(address, options);
  };
}

test('grading can be stopped, and the rest graded later', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await grade(page);
    await press(page, 'hand-ins-cancel');
    await appears(page, 'hand-ins-go-on');
    await haveEnded(page);
    await press(page, 'hand-ins-go-on');
    await disappears(page, 'hand-ins-go-on');
    await isGraded(page);
    assert.equal(await table(page), await expected());
    assert.deepEqual(troubles, []);
  }));
