// Links that come late, and projects and refusals in another page.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { linkTo } from '../link.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, choose, says, writeProgram } from '../words.mjs';

const project = (name) => readFile(path.join(process.env.EXPECTED_PROJECT_RUNS, `${name}.robotran`), 'utf8');

test('a link that comes while the page is open takes the place of the work, which is kept', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 13');
    const link = linkTo('p', JSON.parse(await project('full-of-things-0')));
    await page.evaluate((fragment) => {
      location.hash = fragment;
    }, link);
    await says(page, 'program', /^(?!.*forward 13)/);
    assert.equal(await page.evaluate(() => location.hash), '');
    await choose(page, 'work-menu', 'work-my-work');
    await page.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length >= 2);
    await photograph(page, 'two-works');
    assert.deepEqual(troubles, []);
  }));

test('as a part of another page it shows the project of its link, again after a reload', async () => {
  const link = linkTo('p', JSON.parse(await project('full-of-things-1')));
  await onPage({ width: 800, height: 500, address: `?embed${link}` }, async ({ page, troubles }) => {
    const things = () => page.evaluate(() => document.querySelectorAll('[data-tag^="thing-"]').length);
    await appears(page, 'start-over');
    const before = await things();
    assert.ok(before > 2, `${before} things`);
    await photograph(page, 'embed-link');
    await reload(page);
    await appears(page, 'start-over');
    await page.waitForFunction((count) => document.querySelectorAll('[data-tag^="thing-"]').length === count, before);
    assert.deepEqual(troubles, []);
  });
});

test('as a part of another page it says what is wrong with its link', () =>
  onPage({ width: 800, height: 500, address: '?embed#p=zzzz' }, async ({ page, troubles }) => {
    await says(page, 'document-trouble', /\w{3,}/);
    await photograph(page, 'embed-refused');
    assert.deepEqual(troubles, []);
  }));
