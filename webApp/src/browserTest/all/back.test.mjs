// Back in all that can be opened.
import assert from 'node:assert/strict';
import { hasEntries, openAndGoBack, PHONE, TABLET } from '../back.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, tap, words } from '../words.mjs';

/** What can be opened, the taps that open it, and its tag. */
const ON_A_TABLET = [
  [['menu'], 'menu-settings'],
  [['worlds'], 'worlds-page'],
  [['menu', 'menu-settings'], 'settings'],
  [['menu', 'menu-examples'], 'examples-page'],
  [['menu', 'menu-words'], 'help'],
  [['menu', 'menu-first-page'], 'first-run'],
  [['menu', 'menu-map'], 'map-page'],
  [['menu', 'menu-teachers'], 'teachers-page'],
  [['edit-world'], 'edit-done'],
  [['work-menu', 'work-my-work'], 'document-dialog'],
  [['work-menu', 'work-share-link'], 'document-dialog'],
  [['run-more'], 'run-panel-close'],
  [['find-open'], 'find-close'],
];

test('Back closes each page, dialog and menu, and nothing is left behind', () =>
  onPage({ ...TABLET, welcome: true }, async ({ page, site, troubles }) => {
    await hasEntries(page, 1);
    await page.goBack();
    await disappears(page, 'first-run');
    for (const [steps, opened] of ON_A_TABLET) await openAndGoBack(page, steps, opened);
    await photograph(page, 'after-back');
    assert.equal(page.url(), site.address);
    await page.goBack();
    assert.equal(page.url(), 'about:blank', 'at the bottom Back leaves');
    assert.deepEqual(troubles, []);
  }));

test('on a phone Back goes to the world from the other panes, again after a reload', () =>
  onPage(PHONE, async ({ page, troubles }) => {
    await openAndGoBack(page, ['tab-program'], 'program');
    await appears(page, 'world');
    await openAndGoBack(page, ['menu', 'menu-worlds'], 'worlds-page');
    await tap(page, 'tab-program');
    await appears(page, 'program');
    await hasEntries(page, 1);
    await reload(page);
    await hasEntries(page, await words(page, 'program').count()); // Only what is open has an entry.
    assert.deepEqual(troubles, []);
  }));
