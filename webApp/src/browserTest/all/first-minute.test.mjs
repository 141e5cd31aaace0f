// The first minute of a pupil with a phone: a robot draws after one touch, and something else after three more.
import assert from 'node:assert/strict';
import { photograph, report } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, reports, tap } from '../words.mjs';

/** Counts touches. Nothing else reaches the page: a key would be an error. */
function fingerOn(page) {
  const finger = { touches: 0 };
  finger.touch = async (tag) => {
    finger.touches += 1;
    await tap(page, tag);
  };
  return finger;
}

const SIDE = 20;

for (const [name, screen] of [
  ['phone', PHONE],
  ['phone-across', { width: PHONE.height, height: PHONE.width }],
  ['tablet', TABLET],
])
  test(`one touch to a robot that draws, and three more to one that draws something else (${name})`, () =>
    onPage({ ...screen, hasTouch: true, isMobile: true, welcome: true }, async ({ page, troubles }) => {
      const finger = fingerOn(page);
      await appears(page, 'first-run');
      await photograph(page, `first-minute-welcome-${name}`);
      await finger.touch('try-square');
      await reports(page, (now) => now.inkCentimetres > 1);
      assert.equal(finger.touches, 1);
      await appears(page, 'notice-action');
      await photograph(page, `first-minute-drawing-${name}`);
      await reports(page, (now) => now.status === 'ended');
      assert.ok(Math.abs((await report(page)).inkCentimetres - 4 * SIDE) < 2, 'a square');

      await finger.touch('notice-action');
      await appears(page, 'number-more');
      await photograph(page, `first-minute-number-${name}`);
      await finger.touch('number-more');
      await finger.touch('run');
      await reports(page, (now) => now.status === 'ended' && now.inkCentimetres > 4 * SIDE + 2);
      await photograph(page, `first-minute-changed-${name}`);
      assert.equal(finger.touches, 4);
      assert.deepEqual(troubles, []);
    }));
