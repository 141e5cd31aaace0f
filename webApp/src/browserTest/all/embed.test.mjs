// A course in a frame, and a page around that is of the site itself, or one that the site does not name.
import assert from 'node:assert/strict';
import { assignment, inFrame, world } from '../embed.mjs';
import { message } from '../frame.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { test } from '../tried-again.mjs';
import { appears, placeOf, press, reports, says, words, writeProgram } from '../words.mjs';

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
    // It may be further down in the card of the task, where a screen reader finds it.
    const pressInCard = (tag) => words(app, tag).evaluate((element) => element.click());
    await pressInCard('course-line-next');
    await message(page, 'ready', ({ assignment: { id } }) => id === 'mark-2');
    await says(app, 'course-place', /assignment 2 of 2/);
    await pressInCard('course-line-back');
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
