// A package for learning platforms, made in the page, in a small stand-in for a platform: completed and scored.
import assert from 'node:assert/strict';
import { mkdtemp, readFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { appInFrame } from '../frame.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { platformPage, unpack } from '../platform.mjs';
import { serve } from '../serve.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, asTeacher, press, says, words, writeProgram } from '../words.mjs';

const assignment = {
  format: 'robotran-project',
  version: 1,
  robots: [{ name: 'yellow', programs: [{ name: 'mark.robo', language: 'robolang', text: ['forward 5'] }] }],
  assignment: {
    id: 'mark-1',
    checks: { seeds: { from: 1, to: 3 } },
    solution: [{ name: 'mark.robo', language: 'robolang', text: ['forward 40'] }],
  },
  world: {
    format: 'robotran-world',
    version: 2,
    title: 'To the mark',
    task: 'Drive to the mark.',
    paper: { width: 100, height: 80 },
    robots: [{ start: { x: 30, y: 40, heading: 0 } }],
    goals: [
      { kind: 'reach', region: { rectangle: { x: 60, y: 30, width: 20, height: 20 } } },
      { kind: 'inkLength', atLeast: 10 },
    ],
  },
};
const link = linkTo('p', assignment);

/** Makes the package of the standard `version` in the page, and unpacks it into a folder. */
async function madePackage(version) {
  const tag = `make-scorm-${version}`;
  const folder = await mkdtemp(path.join(tmpdir(), 'package-'));
  await onPage({ ...TABLET, acceptDownloads: true, address: link }, async ({ page, troubles }) => {
    await asTeacher(page, 'teachers-make');
    await appears(page, tag);

    const [download] = await Promise.all([page.waitForEvent('download'), press(page, tag)]);
    assert.match(download.suggestedFilename(), /^To the mark - SCORM (1\.2|2004)\.zip$/);
    const zip = path.join(folder, 'package.zip');
    await download.saveAs(zip);
    await says(page, 'make-packed', /To the mark - SCORM (1\.2|2004)\.zip/);
    const files = await unpack(zip, folder);
    assert.ok(files.includes('imsmanifest.xml') && files.includes('site/index.html'), files.join());
    assert.doesNotMatch(await readFile(path.join(folder, 'assignments.js'), 'utf8'), /forward 40/);
    assert.deepEqual(troubles, []);
  });
  return folder;
}

/** Shows the package in `folder` on a platform that begins with `values`, while `use` runs; returns the values then. */
async function onPlatform(folder, version, values, use) {
  const platform = await serve(folder);
  platform.pages['platform.html'] = platformPage(version, 'start.html?assignment=0', values);
  let kept;
  try {
    await onPage(TABLET, async ({ page: first }) => {
      const page = await first.context().newPage();
      await page.setViewportSize(TABLET);
      await page.goto(`${platform.address}platform.html`);
      const item = await (await page.waitForSelector('iframe')).contentFrame();
      await use({ page, app: await appInFrame(page, item) });
      await photograph(page, `scorm-${version}`);
      kept = await page.evaluate(() => ({ ...values, calls }));
    });
  } finally {
    platform.stop();
  }
  return kept;
}

for (const [version, keys] of [
  ['2004', { score: 'cmi.score.raw', status: 'cmi.completion_status', done: 'completed' }],
  ['1.2', { score: 'cmi.core.score.raw', status: 'cmi.core.lesson_status', done: 'passed' }],
]) {
  test(`with SCORM ${version} a platform learns score and completion, and brings the work back`, async () => {
    const folder = await madePackage(version);
    const value = (page, key) => page.evaluate((name) => values[name], key);
    const becomes = (page, key, wanted) =>
      page.waitForFunction(([name, then]) => values[name] === then, [key, wanted]);
    const kept = await onPlatform(folder, version, {}, async ({ page, app }) => {
      await writeProgram(app, 'forward 39');
      await press(app, 'run');
      await becomes(page, keys.score, '50');
      assert.equal(await value(page, keys.status), 'incomplete');
      await writeProgram(app, 'pen down\nforward 39');
      await press(app, 'run');
      await becomes(page, keys.score, '100');
      await becomes(page, keys.status, keys.done);
      await page.waitForFunction(() => /^#h=a/.test(values['cmi.suspend_data']) && calls.includes('save'));
    });
    assert.equal(kept.calls[0], 'begin');
    assert.ok(kept['cmi.suspend_data'].length < 4096, `${kept['cmi.suspend_data'].length} characters`);
    const { calls, ...values } = kept;
    await onPlatform(folder, version, values, async ({ app }) => {
      await app.waitForFunction(
        () => /pen down\nforward 39/.test(document.querySelector('#robotran-words [data-tag="program"]')?.value),
      );
      assert.ok((await words(app, 'run').count()) > 0);
    });
  });
}
