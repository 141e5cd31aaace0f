// The browser's Back closes the topmost open dialog or menu first and leaves the page only if nothing is open.
import assert from 'node:assert/strict';
import { photograph, reload } from './page.mjs';
import { onPage } from './set-up.mjs';
import { test } from './tried-again.mjs';
import { appears, disappears, tap, tapFor, words } from './words.mjs';

const TABLET = { width: 1180, height: 820, hasTouch: true };
const PHONE = { width: 412, height: 915, hasTouch: true };

/** The number of history entries above the page's own entry, once it is stable. */
async function entries(page) {
  let last = null;
  for (let since = Date.now(); Date.now() - since < 900;) {
    const now = await page.evaluate(() => history.state?.robotran ?? 0);
    if (now !== last) since = Date.now();
    last = now;
    await page.waitForTimeout(60);
  }
  return last;
}

/** Opens `opened` by tapping the tags `steps` in order, and closes it by Back. */
async function openAndGoBack(page, steps, opened) {
  const [first, item] = steps;
  await tapFor(page, first, item ?? opened);
  if (item) await tapFor(page, item, opened);
  assert.ok((await entries(page)) > 0, `${opened} has an entry`);
  await page.goBack();
  await disappears(page, opened);
  assert.equal(await entries(page), 0, `nothing is left of ${opened}`);
}

/** What can be opened, the taps that open it, and its tag. */
const ON_A_TABLET = [
  [['menu'], 'menu-settings'],
  [['worlds'], 'worlds-page'],
  [['menu', 'menu-settings'], 'settings'],
  [['menu', 'menu-examples'], 'examples-page'],
  [['menu', 'menu-words'], 'help'],
  [['menu', 'menu-first-page'], 'first-run'],
  [['edit-world'], 'edit-done'],
  [['work-menu', 'work-my-work'], 'document-dialog'],
  [['work-menu', 'work-share-link'], 'document-dialog'],
  [['run-more'], 'run-panel-close'],
  [['find-open'], 'find-close'],
];

test('Back closes each page, dialog and menu, and nothing is left behind', () =>
  onPage({ ...TABLET, welcome: true }, async ({ page, site, troubles }) => {
    assert.equal(await entries(page), 1);
    await page.goBack();
    await disappears(page, 'first-run');
    for (const [steps, opened] of ON_A_TABLET) await openAndGoBack(page, steps, opened);
    await photograph(page, 'after-back');
    assert.equal(page.url(), site.address);
    await page.goBack();
    assert.equal(page.url(), 'about:blank', 'at the bottom Back leaves');
    assert.deepEqual(troubles, []);
  }));

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

test('what lies over another closes first', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await tap(page, 'find-open');
    await appears(page, 'find-close');
    await tap(page, 'worlds');
    await appears(page, 'worlds-page');
    assert.equal(await entries(page), 2);
    await page.goBack();
    await disappears(page, 'worlds-page');
    await appears(page, 'find-close');
    await page.goBack();
    await disappears(page, 'find-close');
    assert.equal(await entries(page), 0);
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
