// The browser's Back closes the topmost open dialog or menu first and leaves the page only if nothing is open.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hasEntries, TABLET } from '../back.mjs';
import { onPage } from '../set-up.mjs';
import { appears, disappears, tap } from '../words.mjs';

test('what lies over another closes first', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await tap(page, 'find-open');
    await appears(page, 'find-close');
    await tap(page, 'worlds');
    await appears(page, 'worlds-page');
    await hasEntries(page, 2);
    await page.goBack();
    await disappears(page, 'worlds-page');
    await appears(page, 'find-close');
    await page.goBack();
    await disappears(page, 'find-close');
    await hasEntries(page, 0);
    assert.deepEqual(troubles, []);
  }));
