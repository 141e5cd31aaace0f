// The green Run on the brick, all examples in Robolang, and pictures of the page.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { findColour } from '../browser.mjs';
import { assertRecordedRun, photograph, report, RUN_GREEN } from '../page.mjs';
import { browserOptions, onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

test('Run on the brick makes the robot draw the square, with about eighty centimetres of ink', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await photograph(page, 'tablet-before');
    const button = await findColour(page, RUN_GREEN);
    assert.ok(button, 'there is a green Run button to be seen');
    await page.mouse.move(button.x, button.y);
    await page.mouse.down();
    assert.equal((await report(page)).inkCentimetres, 0, 'a program starts when Run is let go');
    await page.mouse.up();
    await page.waitForFunction(() => JSON.parse(globalThis.robotran.report()).inkCentimetres > 30);
    await photograph(page, 'tablet-drawing');
    await page.waitForFunction(() => JSON.parse(globalThis.robotran.report()).status === 'ended');
    await photograph(page, 'tablet-ended');
    const { inkCentimetres } = await report(page);
    assert.ok(inkCentimetres > 79 && inkCentimetres < 81, `${inkCentimetres} cm of ink`);
    assert.deepEqual(troubles, []);
  }));

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
