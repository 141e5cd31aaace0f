// The first visit, a changed world, and German.
import assert from 'node:assert/strict';
import { isKept } from '../kept.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, press, says, words } from '../words.mjs';

test('who is here for the first time is welcomed, and not a second time', () =>
  onPage({ ...TABLET, welcome: true }, async ({ page, troubles }) => {
    await appears(page, 'first-run');
    await photograph(page, 'welcome');
    await press(page, 'first-run-close');
    await disappears(page, 'first-run');
    await reload(page);
    await appears(page, 'run');
    assert.equal(await words(page, 'first-run').count(), 0);
    assert.deepEqual(troubles, []);
  }));

test('the world is changed, and stays changed', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await press(page, 'edit-world');
    await appears(page, 'edit-done');
    await press(page, 'palette-block');
    await isKept(page, '"blocks"');
    await photograph(page, 'world-edited');
    await press(page, 'edit-done');
    await appears(page, 'thing-block-0');
    await reload(page);
    await appears(page, 'thing-block-0');
    assert.deepEqual(troubles, []);
  }));

test('it speaks German to who does', () =>
  onPage({ ...PHONE, locale: 'de-DE' }, async ({ page, troubles }) => {
    assert.equal(await page.evaluate(() => document.documentElement.lang), 'de');
    await says(page, 'tab-program', /Programm/);
    await says(page, 'run', /Starten/);
    await photograph(page, 'phone-german');
    assert.deepEqual(troubles, []);
  }));
