// Links: opened, shared, rejected, and embedded in another page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { linkTo } from '../link.mjs';
import { isReady, photograph } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { appears, choose, press, reports, says, words, writeProgram } from '../words.mjs';

const databases = (page) => page.evaluate(async () => (await indexedDB.databases()).map((database) => database.name));

test('a shared link opens the same program in another browser', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'pen down\nforward 12');
    await choose(page, 'work-menu', 'work-share-link');
    await appears(page, 'qr-code');
    await photograph(page, 'share-link');
    const link = await words(page, 'link-text').inputValue();
    assert.match(link, /^http:\/\/127\.0\.0\.1:\d+\/#p=/);
    const origin = new URL(link);
    await onPage({ ...PHONE, address: origin.hash }, async ({ page: other }) => {
      await press(other, 'tab-program');
      await says(other, 'program', /pen down\nforward 12/);
    });
    assert.deepEqual(troubles, []);
  }));

test('hostile links are refused with a sentence, and the page goes on', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const hostile = {
      'not a link at all': '#p=zzzz',
      'no text': '#p=a____',
      'not a project': linkTo('p', '[1, 2, 3]'),
      'deeper than any project': linkTo('p', '['.repeat(100_000)),
      'inflates without end': linkTo('p', '"'.padEnd(60_000_000, 'a')),
      'a number for a world': linkTo('p', '{"format": 1, "world": 7}'),
    };
    for (const [what, link] of Object.entries(hostile)) {
      await page.evaluate((fragment) => {
        location.hash = fragment;
      }, link);
      await says(page, 'document-trouble', /\w{3,}/).catch(() => assert.fail(what));
      await press(page, 'document-cancel');
      await words(page, 'document-trouble').waitFor({ state: 'detached' });
    }
    await press(page, 'run');
    await reports(page, (report) => report.inkCentimetres > 1);
    assert.deepEqual(troubles, []);
  }));

test('two tabs do not work on the same work', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 14');
    await page.waitForFunction(async () => (await navigator.locks.query()).held.length > 0);
    const other = await page.context().newPage();
    await other.goto(page.url());
    await isReady(other);
    await choose(other, 'work-menu', 'work-my-work');
    await other.waitForFunction(() => document.querySelector('[data-tag^="work-w"]'));
    const tag = await other.evaluate(() => document.querySelector('[data-tag^="work-w"]').dataset.tag);
    await press(other, tag);
    await press(other, 'document-cancel');
    await says(other, 'notice-text', /another window/);
    await photograph(other, 'two-tabs');
    assert.deepEqual(troubles, []);
  }));

test('as a part of another page it shows world and brick, runs, and keeps nothing', () =>
  onPage({ width: 800, height: 500, address: '?embed' }, async ({ page, troubles }) => {
    await appears(page, 'start-over');
    await photograph(page, 'embed');
    assert.equal(await words(page, 'program').count(), 0);
    await press(page, 'run');
    await reports(page, (report) => report.inkCentimetres > 5);
    await press(page, 'stop');
    await reports(page, (report) => report.status === 'ended');
    await press(page, 'start-over');
    await reports(page, (report) => report.inkCentimetres === 0);
    assert.deepEqual(await databases(page), []);
    assert.deepEqual(troubles, []);
  }));
