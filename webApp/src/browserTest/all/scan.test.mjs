// The scanner of QR codes before the camera has started, and without cameras.
import assert from 'node:assert/strict';
import { hasEntries } from '../back.mjs';
import { openHandIns, scanner } from '../scan.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, press, words } from '../words.mjs';

test('Escape ends the scanner while the camera is still starting', () =>
  onPage({ ...TABLET, prepare: wait }, async ({ page, troubles }) => {
    await openHandIns(page);
    await press(page, 'hand-ins-scan');
    await scanner(page).getByRole('status').filter({ hasText: 'starting' }).waitFor();
    await page.keyboard.press('Escape');
    await scanner(page).waitFor({ state: 'detached' });
    await appears(page, 'hand-ins-paste');
    assert.deepEqual(troubles, []);
  }));

test('Back ends the scanner, and the hand-ins stay open', () =>
  onPage({ ...TABLET, prepare: wait }, async ({ page, troubles }) => {
    await openHandIns(page);
    for (let time = 0; time < 2; time++) {
      await press(page, 'hand-ins-scan');
      await scanner(page).getByRole('status').filter({ hasText: 'starting' }).waitFor();
      await hasEntries(page, 2);
      await page.goBack();
      await scanner(page).waitFor({ state: 'detached' });
      await appears(page, 'hand-ins-paste');
      await hasEntries(page, 1);
    }
    await page.goBack();
    await disappears(page, 'hand-ins-paste');
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: a camera that never comes. */
function wait() {
  navigator.mediaDevices.getUserMedia = () => new Promise(() => undefined);
}

test('without cameras there is no button', () =>
  onPage({ ...TABLET, prepare: takeAway }, async ({ page }) => {
    await openHandIns(page);
    assert.equal(await words(page, 'hand-ins-scan').count(), 0);
  }));

/** Runs in the page: as over plain `http`. */
function takeAway() {
  Object.defineProperty(Navigator.prototype, 'mediaDevices', { get: () => undefined });
}
