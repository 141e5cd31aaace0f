// A finger and a mouse on one screen.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { onPage, TABLET } from '../set-up.mjs';
import { appears, placeOf, press } from '../words.mjs';

test('a finger presses what has come to lie under a mouse that rests', () =>
  onPage({ ...TABLET, hasTouch: true, welcome: true }, async ({ page, troubles }) => {
    await press(page, 'first-run-close');
    const { x, y } = await placeOf(page, 'menu');
    await page.touchscreen.tap(x, y);
    await appears(page, 'menu-settings');
    assert.deepEqual(troubles, []);
  }));
