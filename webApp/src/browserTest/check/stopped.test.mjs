// What stops the page, or would: work that is never opened to its end, a database that never answers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isKept } from '../kept.mjs';
import { isReady, photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { choose, isSaid, press, says, writeProgram } from '../words.mjs';

/** Runs in a page: what it notes while it opens a saved project stays, as if it had been stopped before the end. */
function opensToNoEnd() {
  const remove = Storage.prototype.removeItem;
  Storage.prototype.removeItem = function removeItem(key) {
    if (!/^robotran-opening-w/.test(key)) remove.call(this, key);
  };
}

/** Runs in a page: its database never answers. */
function neverAnswers() {
  IDBFactory.prototype.open = () => ({});
}

test('work that stopped the page is asked about at the next visit, with the way to all other work in sight', () =>
  onPage(TABLET, async ({ page, site }) => {
    await writeProgram(page, 'forward 31');
    await isKept(page, 'forward 31');
    const first = await page.evaluate(() => sessionStorage.getItem('robotran-work'));
    await choose(page, 'work-menu', 'work-new');
    await writeProgram(page, 'forward 32');
    await isKept(page, 'forward 32');
    const context = page.context();
    await page.close();

    // A page that stands still can only be killed, as this one is.
    const victim = await context.newPage();
    await victim.addInitScript(opensToNoEnd);
    await victim.goto(site.address);
    await victim.waitForFunction(() => Object.keys(localStorage).some((key) => /^robotran-opening-w/.test(key)));
    await Promise.all([victim.waitForEvent('crash'), victim.goto('chrome://crash').catch(() => undefined)]);

    const next = await context.newPage();
    await next.goto(site.address);
    await isReady(next);
    await isSaid(next, /“My first work 2” stopped Robotran last time/);
    await photograph(next, 'stopped-last-time');
    await press(next, 'stopped-my-work');
    await next.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length === 2);
    await photograph(next, 'my-work-with-what-stopped-the-page');
    await press(next, `work-${first}`);
    await says(next, 'program', /forward 31/);
  }));

test('a page whose database never answers runs without it, and says so', () =>
  onPage({ ...TABLET, prepare: neverAnswers }, async ({ page, troubles }) => {
    await isSaid(page, /storage of this browser does not answer/);
    await photograph(page, 'database-silent');
    await writeProgram(page, 'forward 33');
    await says(page, 'program', /forward 33/);
    const saved = page.waitForEvent('download');
    await press(page, 'trouble-save-as');
    assert.match((await saved).suggestedFilename(), /\.robotran$/);
    assert.deepEqual(troubles, []);
  }));
