// The browser's Back closes the topmost open dialog or menu first and leaves the page only if nothing is open.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hasEntries, openAndGoBack, TABLET } from '../back.mjs';
import { onPage } from '../set-up.mjs';
import { appears, disappears, tap, words } from '../words.mjs';

test('what is closed in another way leaves no entry, and Forward brings nothing back', () =>
  onPage(TABLET, async ({ page, site, troubles }) => {
    await tap(page, 'worlds');
    await appears(page, 'worlds-page');
    await hasEntries(page, 1);
    await page.keyboard.press('Escape');
    await disappears(page, 'worlds-page');
    await hasEntries(page, 0);
    await page.goForward();
    await hasEntries(page, 0);
    assert.equal(await words(page, 'worlds-page').count(), 0);
    await openAndGoBack(page, ['edit-world'], 'edit-done');
    assert.equal(page.url(), site.address);
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: the browser goes back where the page asks for it only with `goAtLast`. */
function goesLate() {
  const { go } = History.prototype;
  globalThis.asked = [];
  History.prototype.go = function (steps) {
    globalThis.asked.push(steps);
  };
  globalThis.goAtLast = () => {
    History.prototype.go = go;
    for (const steps of globalThis.asked) history.go(steps);
  };
}

test('a browser that goes back late closes nothing that was opened meanwhile, and stays in the page', () =>
  onPage(TABLET, async ({ page, site, troubles }) => {
    await page.evaluate(goesLate);
    await tap(page, 'find-open');
    await appears(page, 'find-close');
    await hasEntries(page, 1);
    await page.keyboard.press('Escape');
    await disappears(page, 'find-close');
    await page.waitForFunction(() => globalThis.asked.length > 0);
    await tap(page, 'worlds');
    await appears(page, 'worlds-page');
    const went = page.evaluate(() => new Promise((resolve) => addEventListener('popstate', () => resolve())));
    await page.evaluate(() => globalThis.goAtLast());
    await went;
    await hasEntries(page, 1);
    assert.equal(await words(page, 'worlds-page').count(), 1);
    await page.goBack();
    await disappears(page, 'worlds-page');
    assert.equal(page.url(), site.address);
    assert.deepEqual(troubles, []);
  }));

test('a link that is opened before the browser has gone back stays open', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await page.evaluate(goesLate);
    await tap(page, 'find-open');
    await hasEntries(page, 1);
    await page.keyboard.press('Escape');
    await page.waitForFunction(() => globalThis.asked.length > 0);
    await page.evaluate(() => {
      location.hash = '#p=zzzz';
    });
    await appears(page, 'document-trouble');
    const went = page.evaluate(() => new Promise((resolve) => addEventListener('popstate', () => resolve())));
    await page.evaluate(() => globalThis.goAtLast());
    await went;
    await hasEntries(page, 1);
    assert.equal(await words(page, 'document-trouble').count(), 1);
    assert.deepEqual(troubles, []);
  }));

test('as a part of another page it leaves the history alone', () =>
  onPage({ width: 800, height: 500, address: '?embed' }, async ({ page, troubles }) => {
    await appears(page, 'start-over');
    assert.equal(await page.evaluate(() => history.state), null);
    assert.deepEqual(troubles, []);
  }));
