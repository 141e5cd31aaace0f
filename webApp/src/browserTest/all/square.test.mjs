// All examples in Robolang, and pictures of the page.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { assertRecordedRun, photograph } from '../page.mjs';
import { browserOptions, onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

test('every example makes its recorded run in the browser, bit for bit', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const examples = process.env.EXAMPLES.split(path.delimiter).filter((file) => file.endsWith('.robo'));
    assert.notEqual(examples.length, 0);
    for (const example of examples) await assertRecordedRun(page, example, process.env.EXPECTED_RUNS);
    assert.deepEqual(troubles, []);
  }));

test('every example that an NXT can run makes its recorded run on one, bit for bit', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const runs = process.env.EXPECTED_NXT_RUNS;
    const isRecorded = (file) => existsSync(path.join(runs, `${path.basename(file, '.robo')}.report.json`));
    const examples = process.env.EXAMPLES.split(path.delimiter).filter((file) => file.endsWith('.robo') && isRecorded(file));
    assert.ok(examples.length > 20, `${examples.length} examples`);
    for (const example of examples) await assertRecordedRun(page, example, runs, 'nxt');
    assert.deepEqual(troubles, []);
  }));

test('the page fits a phone and a laptop, by day and by night', async () => {
  for (const [name, size] of Object.entries({
    phone: PHONE,
    'phone-dark': { ...PHONE, dark: true },
    laptop: { width: 1440, height: 900 },
    'laptop-dark': { width: 1440, height: 900, dark: true },
  })) {
    await onPage(size, async ({ page, troubles }) => {
      await photograph(page, name);
      assert.deepEqual(troubles, [], name);
    });
  }
});
