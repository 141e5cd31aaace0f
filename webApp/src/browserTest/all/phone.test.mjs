// On a phone, all of a menu and of a tutorial step is reachable, and everything opened can be closed.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, placeOf, tap, tapFor, words } from '../words.mjs';

const PHONE = { width: 412, height: 915, hasTouch: true };

/** Fails unless `tag` is completely on the screen. */
async function assertInSight(page, tag) {
  await placeOf(page, tag);
  const box = await words(page, tag).first().boundingBox();
  const isInside =
    box.x >= -1 && box.y >= -1 && box.x + box.width <= PHONE.width + 1 && box.y + box.height <= PHONE.height + 1;
  assert.ok(isInside, `${tag} is at ${JSON.stringify(box)}`);
}

test('a phone shows the whole menu, and in it a list of what can be done with the work', () =>
  onPage(PHONE, async ({ page, troubles }) => {
    await tapFor(page, 'menu', 'menu-settings');
    for (const tag of ['work-menu', 'menu-map', 'menu-settings', 'menu-teachers']) await assertInSight(page, tag);
    await photograph(page, 'phone-menu');
    await tapFor(page, 'work-menu', 'work-new');
    for (const tag of ['menu-back', 'work-new', 'work-share-link', 'work-more']) await assertInSight(page, tag);
    await photograph(page, 'phone-work-menu');
    await tapFor(page, 'work-more', 'work-kit');
    for (const tag of ['menu-back', 'work-open', 'work-save-as', 'work-kit']) await assertInSight(page, tag);
    await tapFor(page, 'menu-back', 'work-new');
    await tapFor(page, 'menu-back', 'menu-settings');
    await tapFor(page, 'work-menu', 'work-my-work');
    await tapFor(page, 'work-my-work', 'document-dialog');
    assert.deepEqual(troubles, []);
  }));

test('Escape closes the settings after another language was chosen with a finger', () =>
  onPage(PHONE, async ({ page, troubles }) => {
    await tapFor(page, 'menu', 'menu-settings');
    await tapFor(page, 'menu-settings', 'language-2');
    await tap(page, 'language-2');
    await page.waitForTimeout(1_500);
    await page.keyboard.press('Escape');
    await disappears(page, 'language-2');
    assert.deepEqual(troubles, []);
  }));

test('with a hint open, what can be done with a lesson stays in sight', () =>
  onPage(PHONE, async ({ page, troubles }) => {
    await tapFor(page, 'menu', 'menu-map');
    await tapFor(page, 'menu-map', 'lesson-first-drive');
    await tap(page, 'lesson-first-drive');
    await appears(page, 'hint-wanted');
    await tapFor(page, 'hint-wanted', 'hint');
    for (const tag of ['previous-step', 'step-more', 'next-step']) await assertInSight(page, tag);
    await photograph(page, 'phone-tutorial-hint');
    await tapFor(page, 'step-more', 'leave-tutorial');
    await tap(page, 'leave-tutorial');
    await disappears(page, 'tutorial-steps');
    assert.deepEqual(troubles, []);
  }));
