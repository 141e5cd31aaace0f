// An assignment in a frame: what the page around learns, and who may be around.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { appInFrame, message, pageAround } from '../frame.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { appears, placeOf, press, reports, says, words, writeProgram } from '../words.mjs';

const world = {
  format: 'robotran-world',
  version: 2,
  title: 'To the mark',
  task: 'Drive to the mark.',
  paper: { width: 100, height: 80 },
  robots: [{ start: { x: 30, y: 40, heading: 0 } }],
  goals: [{ kind: 'reach', region: { rectangle: { x: 60, y: 30, width: 20, height: 20 } } }],
};
const program = { name: 'mark.robo', language: 'robolang', text: ['forward 5'] };
const assignment = {
  format: 'robotran-project',
  version: 1,
  robots: [{ name: 'yellow', programs: [program] }],
  assignment: { id: 'mark-1', text: ['Use `forward`.'] },
  world,
};
const link = linkTo('p', assignment);

/**
 * Shows the assignment in a frame of a page at another origin, while `use` runs. `origins` are those that the site
 * allows; `work` is what that page brings back.
 */
const inFrame = ({ origins, work = '', isSame = false, shown = link }, use) =>
  onPage(TABLET, async ({ page: first, site, troubles }) => {
    const other = isSame ? site.address : site.address.replace('127.0.0.1', 'localhost');
    site.pages['embedding.json'] = JSON.stringify({ origins: origins(new URL(other).origin) });
    site.pages['around.html'] = pageAround(`${site.address}?embed=assignment${shown}`, work);
    const page = await first.context().newPage();
    await page.setViewportSize(TABLET);
    page.on('pageerror', (error) => troubles.push(String(error)));
    try {
      await page.goto(`${other}around.html`);
      await use({ page, app: await appInFrame(page), site });
      assert.deepEqual(troubles, []);
    } finally {
      site.pages = {};
    }
  });

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

test('a course in a frame shows how far it is, and leads on to the next assignment', () => {
  const second = {
    ...assignment,
    assignment: { id: 'mark-2', text: ['Use `forward`.'] },
    world: { ...world, title: 'To the mark again' },
  };
  const course = { format: 'robotran-course', version: 1, title: 'Marks', assignments: [assignment, second] };
  const shown = linkTo('c', course);
  return inFrame({ origins: (origin) => [origin], shown }, async ({ page, app }) => {
    await says(app, 'course-done', /0 of 2/);
    await press(app, 'course-go-on');
    assert.deepEqual((await message(page, 'ready')).assignment, { id: 'mark-1', title: 'To the mark' });
    await says(app, 'course-place', /Marks: assignment 1 of 2/);
    await photograph(page, 'course-in-frame');
    await press(app, 'course-line-next');
    await message(page, 'ready', ({ assignment: { id } }) => id === 'mark-2');
    await says(app, 'course-place', /assignment 2 of 2/);
    await press(app, 'course-line-back');
    await appears(app, 'course-done');
  });
});

test('a page of the same origin needs no permission', () =>
  inFrame({ origins: () => [], isSame: true }, async ({ page }) => {
    assert.equal((await message(page, 'ready')).assignment.id, 'mark-1');
  }));

test('a page that the site does not name learns nothing, and the pupil works all the same', () =>
  inFrame({ origins: () => ['https://school.example', '*', 'http://localhost'] }, async ({ page, app }) => {
    await writeProgram(app, 'forward 39');
    await press(app, 'run');
    await reports(app, (report) => report.goals[0].met);
    // What the page around would hear of that has been told after some frames.
    await placeOf(app, 'run');
    await app.evaluate(() => parent.postMessage({ kind: 'last' }, '*'));
    await message(page, 'last');
    assert.equal((await page.evaluate(() => messages)).length, 1);
    assert.ok((await words(app, 'program').count()) > 0);
  }));
