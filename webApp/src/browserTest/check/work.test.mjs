// Projects saved in the browser: opened from a link, restored after a reload and in a new page, separate in two tabs.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { areSaved, savedProjects } from '../kept.mjs';
import { linkTo } from '../link.mjs';
import { isReady, photograph, reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';

test('a link opens its project, which is kept and not opened again by a reload', () =>
  onPage(TABLET, async ({ page, site, troubles }) => {
    const text = await readFile(path.join(process.env.EXPECTED_PROJECT_RUNS, 'full-of-things-0.robotran'), 'utf8');
    const fragment = linkTo('p', JSON.parse(text));
    assert.deepEqual(await savedProjects(page), [], 'nothing was done, so nothing is kept');
    await page.evaluate((link) => {
      location.hash = link;
    }, fragment);
    const [kept] = await areSaved(page, 1);
    await photograph(page, 'work-from-link');
    assert.match(kept, /^robotran-work 1\n/);
    assert.equal(await page.evaluate(() => location.hash), '', 'the link is taken out of the address');

    await reload(page);
    await photograph(page, 'work-after-reload');
    assert.equal((await savedProjects(page)).length, 1, 'the same work is taken up again');

    const other = await page.context().newPage();
    await other.goto(site.address + fragment);
    await isReady(other);
    await areSaved(other, 2); // another tab has its own project
    assert.deepEqual(troubles, []);
  }));
