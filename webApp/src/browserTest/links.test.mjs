// Links: opened, shared, rejected, and embedded in another page.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { isReady, photograph, reload } from './page.mjs';
import { onPage, PHONE, TABLET } from './set-up.mjs';
import { test } from './tried-again.mjs';
import { appears, choose, press, reports, says, words, writeProgram } from './words.mjs';

const linkTo = (text) => `#p=a${deflateRawSync(text).toString('base64url')}`;
const project = (name) => readFile(path.join(process.env.EXPECTED_PROJECT_RUNS, `${name}.robotran`), 'utf8');
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

test('a link that comes while the page is open takes the place of the work, which is kept', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 13');
    const link = linkTo(JSON.stringify(JSON.parse(await project('full-of-things-0'))));
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

test('hostile links are refused with a sentence, and the page goes on', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const hostile = {
      'not a link at all': '#p=zzzz',
      'no text': '#p=a____',
      'not a project': linkTo('[1, 2, 3]'),
      'deeper than any project': linkTo('['.repeat(100_000)),
      'inflates without end': linkTo('"'.padEnd(60_000_000, 'a')),
      'a number for a world': linkTo('{"format": 1, "world": 7}'),
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

test('as a part of another page it shows the project of its link, again after a reload', async () => {
  const link = linkTo(JSON.stringify(JSON.parse(await project('full-of-things-1'))));
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
