// Tabs of one browser: each restores its own project.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isKept } from '../kept.mjs';
import { isReady, photograph, reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { closeTab } from '../tabs.mjs';
import { choose, says, words, writeProgram } from '../words.mjs';

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
