// An assignment in a frame: what the page around learns.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inFrame } from '../embed.mjs';
import { message } from '../frame.mjs';
import { photograph } from '../page.mjs';
import { press, writeProgram } from '../words.mjs';

test('the page around learns how the pupil gets on, and brings the work back', async () => {
  let work = '';
  await inFrame({ origins: (origin) => [origin] }, async ({ page, app, site }) => {
    const ready = await message(page, 'ready');
    assert.deepEqual(ready.assignment, { id: 'mark-1', title: 'To the mark' });
    assert.equal(ready.origin, new URL(site.address).origin);
    await writeProgram(app, 'forward 39');
    await press(app, 'run');
    const result = await message(page, 'result', ({ completed }) => completed);
    assert.deepEqual([result.goalsMet, result.goals, result.score, result.tries], [1, 1, 1, 1]);
    assert.ok(result.seconds > 1, `${result.seconds} s`);
    work = (await message(page, 'work')).work;
    assert.match(work, /^#h=a/);
    await photograph(page, 'assignment-in-frame');
    const databases = () => indexedDB.databases().then((all) => all.map(({ name }) => name)).catch(() => []);
    assert.deepEqual(await app.evaluate(databases), [], 'nothing is kept on the device');
  });
  await inFrame({ origins: (origin) => [origin], work }, async ({ page, app }) => {
    await message(page, 'result', ({ completed }) => completed);
    await app.waitForFunction(
      () => /forward 39/.test(document.querySelector('#robotran-words [data-tag="program"]')?.value),
    );
  });
});
