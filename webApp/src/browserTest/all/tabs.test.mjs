// Tabs that are closed right after a key, doubled, or crash.
import assert from 'node:assert/strict';
import { isKept } from '../kept.mjs';
import { isReady } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { closeTab } from '../tabs.mjs';
import { test } from '../tried-again.mjs';
import { choose, enterProgram, says, words, writeProgram } from '../words.mjs';

/** From now on writes to the page's database are dropped silently. */
function neverWrites() {
  const begin = IDBDatabase.prototype.transaction;
  IDBDatabase.prototype.transaction = function transaction(names, mode, options) {
    if (mode !== 'readwrite') return begin.call(this, names, mode, options);
    return { objectStore: () => ({ put: () => ({}), delete: () => ({}) }), commit: () => undefined };
  };
}

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
