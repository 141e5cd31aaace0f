// The screen is turned.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { onPage, PHONE } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, press, reports } from '../words.mjs';

test('turning the screen arranges it anew and keeps what was done', () =>
  onPage({ ...PHONE, hasTouch: true }, async ({ page, troubles }) => {
    await press(page, 'run');
    await reports(page, (report) => report.inkCentimetres > 3);
    await page.setViewportSize({ width: 891, height: 411 });
    await page.waitForFunction(() => document.querySelector('canvas').clientWidth === 891);
    await photograph(page, 'phone-across');
    await page.setViewportSize({ width: 1280, height: 800 });
    await appears(page, 'full-world');
    await reports(page, (report) => report.inkCentimetres > 8);
    assert.deepEqual(troubles, []);
  }));
