// Hand-ins are graded in workers, with the same results as on the JVM, and the page stays alive meanwhile.
import assert from 'node:assert/strict';
import { costsItsRow, expected, grade, haveEnded, isGraded, table } from '../grading.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, press } from '../words.mjs';

test('workers give a class with an RCX the same grades as the JVM', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const workers = [];
    page.on('worker', (worker) => workers.push(worker));
    await grade(page);
    await isGraded(page);
    assert.equal(await table(page), await expected());
    assert.ok(workers.length >= 1, `${workers.length} workers`);
    await haveEnded(page);
    assert.deepEqual(troubles, []);
  }));

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
