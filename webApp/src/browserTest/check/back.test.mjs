// The browser's Back closes the topmost open dialog or menu first and leaves the page only if nothing is open.
import assert from 'node:assert/strict';
import { entries, openAndGoBack, PHONE, TABLET } from '../back.mjs';
import { reload } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, tap, words } from '../words.mjs';

test('what is closed in another way leaves no entry, and Forward brings nothing back', () =>
  onPage(TABLET, async ({ page, site, troubles }) => {
    await tap(page, 'worlds');
    await appears(page, 'worlds-page');
    assert.equal(await entries(page), 1);
    await page.keyboard.press('Escape');
    await disappears(page, 'worlds-page');
    assert.equal(await entries(page), 0);
    await page.goForward();
    assert.equal(await entries(page), 0);
    assert.equal(await words(page, 'worlds-page').count(), 0);
    await openAndGoBack(page, ['edit-world'], 'edit-done');
    assert.equal(page.url(), site.address);
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: the browser is slow to go back where the page asks for it. */
function goesSlowly() {
  const { go } = History.prototype;
  History.prototype.go = function (steps) {
    setTimeout(() => go.call(this, steps), 2_500);
  };
}

test('a browser that goes back late closes nothing that was opened meanwhile, and stays in the page', () =>
  onPage({ ...TABLET, prepare: goesSlowly }, async ({ page, site, troubles }) => {
    await tap(page, 'find-open');
    await appears(page, 'find-close');
    assert.equal(await entries(page), 1);
    await page.keyboard.press('Escape');
    await disappears(page, 'find-close');
    await page.waitForTimeout(500); // It is asked for, and not yet there.
    await tap(page, 'worlds');
    await appears(page, 'worlds-page');
    await page.waitForTimeout(3_000);
    assert.equal(await words(page, 'worlds-page').count(), 1);
    assert.equal(await entries(page), 1);
    await page.goBack();
    await disappears(page, 'worlds-page');
    assert.equal(page.url(), site.address);
    assert.deepEqual(troubles, []);
  }));

test('on a phone Back goes to the world from the other panes, again after a reload', () =>
  onPage(PHONE, async ({ page, troubles }) => {
    await openAndGoBack(page, ['tab-program'], 'program');
    await appears(page, 'world');
    await openAndGoBack(page, ['menu', 'menu-worlds'], 'worlds-page');
    await tap(page, 'tab-program');
    await appears(page, 'program');
    assert.equal(await entries(page), 1);
    await reload(page);
    const there = await words(page, 'program').count();
    assert.equal(await entries(page), there, 'only what is open has an entry');
    assert.deepEqual(troubles, []);
  }));

test('as a part of another page it leaves the history alone', () =>
  onPage({ width: 800, height: 500, address: '?embed' }, async ({ page, troubles }) => {
    await appears(page, 'start-over');
    assert.equal(await page.evaluate(() => history.state), null);
    assert.deepEqual(troubles, []);
  }));
