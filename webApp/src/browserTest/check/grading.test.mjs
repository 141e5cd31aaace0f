// Hand-ins are graded in workers, with the same results as on the JVM, and the page stays alive meanwhile.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { expected, grade, haveEnded, isGraded, table } from '../grading.mjs';
import { onPage, TABLET } from '../set-up.mjs';

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
