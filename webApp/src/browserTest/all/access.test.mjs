// Less motion.
import assert from 'node:assert/strict';
import { reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { choose, disappears, press, words } from '../words.mjs';

/** Opens the settings, and waits until the switch for less motion is as it should be. */
async function lessMotionIs(page, isOn) {
  if ((await words(page, 'less-motion').count()) === 0) await choose(page, 'menu', 'menu-settings');
  await words(page, 'less-motion').and(page.locator(`[aria-checked="${isOn}"]`)).waitFor({ state: 'attached' });
}

test('the wish of the device for less motion counts, until one chooses', () =>
  onPage({ ...TABLET, reducedMotion: 'reduce' }, async ({ page, troubles }) => {
    await lessMotionIs(page, true);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await lessMotionIs(page, false);
    await press(page, 'less-motion');
    await lessMotionIs(page, true);
    await press(page, 'settings-close');
    await disappears(page, 'settings-close');
    await reload(page);
    await lessMotionIs(page, true);
    assert.deepEqual(troubles, []);
  }));
