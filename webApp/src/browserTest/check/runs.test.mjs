// One recorded run for each language and brick. All of them run on the JVM and in Node; `all` runs them here, too.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { assertRecordedRun } from '../page.mjs';
import { browserOptions, onPage, TABLET } from '../set-up.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

test('programs in each language for each brick, and a project full of things, make their recorded runs, bit for bit', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const example = (...name) =>
      process.env.EXAMPLES.split(path.delimiter).find((file) => file.endsWith(path.join('examples', ...name)));
    await assertRecordedRun(page, example('line-follower.robo'), process.env.EXPECTED_RUNS);
    await assertRecordedRun(page, example('line-follower.robo'), process.env.EXPECTED_NXT_RUNS, 'nxt');
    await assertRecordedRun(page, example('lejos', 'LineFollower.java'), process.env.EXPECTED_JAVA_RUNS);
    await assertRecordedRun(page, example('nxj', 'LineFollower.java'), process.env.EXPECTED_NXJ_RUNS);
    await assertRecordedRun(page, example('nqc', 'line-follower.nqc'), process.env.EXPECTED_NQC_RUNS);
    const project = path.join(process.env.EXPECTED_PROJECT_RUNS, 'full-of-things-0');
    const run = await page.evaluate(
      (text) => globalThis.robotran.runProject(text, 60_000),
      await readFile(`${project}.robotran`, 'utf8'),
    );
    assert.equal(`${run.report}\n`, await readFile(`${project}.report.json`, 'utf8'));
    assert.deepEqual(troubles, []);
  }));
