// Tabs of one browser: each restores its own project, and only a crash is reported as one.
import assert from 'node:assert/strict';
import { isKept } from './kept.mjs';
import { isReady, photograph, reload } from './page.mjs';
import { onPage, TABLET } from './set-up.mjs';
import { test } from './tried-again.mjs';
import { choose, enterProgram, says, words, writeProgram } from './words.mjs';

/** Closes a tab as a pupil does, and waits until it is gone, which Playwright does not. */
async function closeTab(page) {
  const gone = page.waitForEvent('close');
  await page.close({ runBeforeUnload: true });
  await gone;
}

/** From now on writes to the page's database are dropped silently. */
function neverWrites() {
  const begin = IDBDatabase.prototype.transaction;
  IDBDatabase.prototype.transaction = function transaction(names, mode, options) {
    if (mode !== 'readwrite') return begin.call(this, names, mode, options);
    return { objectStore: () => ({ put: () => ({}), delete: () => ({}) }), commit: () => undefined };
  };
}

test('each of two tabs comes back with its own work, under a name of its own', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 21');
    await isKept(page, 'forward 21');
    const other = await page.context().newPage();
    await other.goto(page.url());
    await isReady(other);
    await says(other, 'work-menu', /My first work 2/);
    await says(other, 'notice-text', /“My first work” is open in another window/);
    await writeProgram(other, 'forward 22');
    await isKept(other, 'forward 22');
    await reload(other);
    await says(other, 'program', /forward 22/);
    await closeTab(other);
    await reload(page);
    await says(page, 'program', /forward 21/);
    await says(page, 'work-menu', /My first work(?! 2)/);
    assert.equal(await words(page, 'notice-text').count(), 0, 'nothing has crashed');
    await choose(page, 'work-menu', 'work-my-work');
    await page.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length === 2);
    await photograph(page, 'my-work-of-two-tabs');
    assert.deepEqual(troubles, []);
  }));

test('a duplicated tab begins a work of its own and says where the other is', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 23');
    await isKept(page, 'forward 23');
    const memory = await page.evaluate(() => sessionStorage.getItem('robotran-work'));
    const twin = await page.context().newPage();
    // A browser copies the session storage of a duplicated tab.
    await twin.addInitScript((id) => {
      if (!sessionStorage.getItem('robotran-work')) sessionStorage.setItem('robotran-work', id);
    }, memory);
    await twin.goto(page.url());
    await isReady(twin);
    await says(twin, 'notice-text', /open in another window/);
    await says(twin, 'program', /^(?!.*forward 23)/);
    await says(page, 'program', /forward 23/);
    assert.deepEqual(troubles, []);
  }));

test('a reload right after a key loses nothing and says nothing', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    for (const number of [31, 32, 33]) {
      await writeProgram(page, `forward ${number}`);
      await reload(page);
      await says(page, 'program', new RegExp(`forward ${number}`));
      assert.equal(await words(page, 'notice-text').count(), 0);
    }
    assert.deepEqual(troubles, []);
  }));

test('a tab that is closed right after a key loses nothing, whether it has kept anything yet or not, and however slow the disk is', () =>
  onPage(TABLET, async ({ page, site }) => {
    const another = async () => {
      const next = await page.context().newPage();
      await next.goto(site.address);
      await isReady(next);
      return next;
    };
    // The very first key.
    await enterProgram(page);
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('7');
    await closeTab(page);
    let next = await another();
    await says(next, 'program', /^7/);
    await says(next, 'work-menu', /My first work(?! 2)/);
    for (const number of [41, 42, 43]) {
      await writeProgram(next, `forward ${number}`);
      await isKept(next, `forward ${number}`);
      // The database never finishes a write.
      if (number > 41) await next.evaluate(neverWrites);
      await next.keyboard.type('7');
      // Also without the beforeunload event, as when the browser quits. It ends a page that is slow to hear of it, as on a
      // busy machine; so the page hears of it before.
      if (number === 43) {
        await next.evaluate(() => dispatchEvent(new PageTransitionEvent('pagehide')));
        await next.close();
      } else {
        await closeTab(next);
      }
      next = await another();
      // Behind the text is the field's label, unless the field has the focus.
      await says(next, 'program', new RegExp(`^forward ${number}7(?!\\w*\\d)`));
      assert.equal(await words(next, 'notice-text').count(), 0, 'nothing has crashed');
    }
    await choose(next, 'work-menu', 'work-my-work');
    await next.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length > 0);
    assert.equal(await next.locator('#robotran-words [data-tag^="work-w"]').count(), 1, 'all of it is one work');
    assert.deepEqual(
      await next.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('robotran-left-'))),
      [],
    );
  }));

test('a tab that has crashed says so when its work comes back', () =>
  onPage(TABLET, async ({ page, site }) => {
    await writeProgram(page, 'forward 24');
    await isKept(page, 'forward 24');
    const context = page.context();
    await Promise.all([page.waitForEvent('crash'), page.goto('chrome://crash').catch(() => undefined)]);
    const next = await context.newPage();
    await next.goto(site.address);
    await isReady(next);
    await says(next, 'program', /forward 24/);
    await says(next, 'notice-text', /did not end as it should/);
  }));
