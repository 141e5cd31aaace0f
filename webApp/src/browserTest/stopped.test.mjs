// What stops the page, or would: work that is never opened to its end, a compiler and a database that never answer.
import assert from 'node:assert/strict';
import { isKept } from './kept.mjs';
import { isReady, photograph } from './page.mjs';
import { onPage, TABLET } from './set-up.mjs';
import { test } from './tried-again.mjs';
import { choose, isSaid, press, says, writeProgram } from './words.mjs';

/** Runs in a page: it stands still for ever as soon as it begins to open a saved project, like one with a compiler that never answers. */
function standsStill() {
  const put = Storage.prototype.setItem;
  Storage.prototype.setItem = function setItem(key, value) {
    put.call(this, key, value);
    if (!/^robotran-opening-w/.test(key) || localStorage.getItem('test-harm') !== 'yes') return;
    const telling = new XMLHttpRequest();
    telling.open('GET', 'stands-still', false);
    telling.send();
    for (;;);
  };
}

/** Runs in a page: the worker that compiles Java is there and never answers. */
function neverCompiles() {
  const Original = Worker;
  globalThis.Worker = function Worker(address, options) {
    if (!/ecj-worker/.test(address)) return new Original(address, options);
    const silent = { postMessage: () => undefined, terminate: () => (globalThis.ended = (globalThis.ended ?? 0) + 1) };
    setTimeout(() => silent.onmessage({ data: { kind: 'ready' } }));
    return silent;
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
    await choose(page, 'work-menu', 'work-new');
    await writeProgram(page, 'forward 32');
    await isKept(page, 'forward 32');
    const context = page.context();
    await page.evaluate(() => localStorage.setItem('test-harm', 'yes'));
    await page.close();

    await context.addInitScript(standsStill);
    const victim = await context.newPage();
    const stands = victim.waitForRequest(/stands-still$/, { timeout: 90_000 });
    await victim.goto(site.address);
    await stands;
    await victim.close();

    const next = await context.newPage();
    await next.goto(site.address);
    await isReady(next);
    await isSaid(next, /“My first work 2” stopped Robotran last time/);
    await photograph(next, 'stopped-last-time');
    await press(next, 'stopped-my-work');
    await next.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length === 2);
    await photograph(next, 'my-work-with-what-stopped-the-page');
    const one = next.locator('#robotran-words [data-tag^="work-w"]').filter({ hasNotText: 'My first work 2' });
    await next.evaluate(() => localStorage.removeItem('test-harm'));
    await press(next, await one.first().getAttribute('data-tag'));
    await says(next, 'program', /forward 31/);
  }));

test('a Java program that keeps the compiler busy has a mistake that says so, and the page stays alive', () =>
  onPage({ ...TABLET, prepare: neverCompiles }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await says(page, 'program', /class/);
    await writeProgram(page, 'class A');
    await says(page, 'program', /class A/);
    await isSaid(page, /keeps the compiler for Java busy for too long/);
    assert.ok((await page.evaluate(() => globalThis.ended)) >= 1, 'the worker is ended');
    await photograph(page, 'compiler-busy');
    assert.deepEqual(troubles, []);
  }));

test('a page whose database never answers runs without it, and says so at once', () =>
  onPage({ ...TABLET, prepare: neverAnswers }, async ({ page, troubles }) => {
    await says(page, 'keeping-trouble', /storage of this browser does not answer/);
    await photograph(page, 'database-silent');
    await writeProgram(page, 'forward 33');
    await says(page, 'program', /forward 33/);
    const saved = page.waitForEvent('download');
    await press(page, 'trouble-save-as');
    assert.match((await saved).suggestedFilename(), /\.robotran$/);
    assert.deepEqual(troubles, []);
  }));
