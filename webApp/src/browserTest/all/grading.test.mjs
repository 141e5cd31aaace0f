// Hand-ins of a class with an NXT, a page without workers, and a worker that never answers.
import assert from 'node:assert/strict';
import { costsItsRow, expected, grade, haveEnded, isGraded, NXT, RCX, table } from '../grading.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';

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
