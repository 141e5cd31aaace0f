// Drives the built page like a pupil: finds the green Run on the brick, presses it, and waits until the robot draws.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { findColour } from '../browser.mjs';
import { photograph, report, RUN_GREEN } from '../page.mjs';
import { browserOptions, onPage, TABLET } from '../set-up.mjs';

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
