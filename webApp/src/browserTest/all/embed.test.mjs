// A course in a frame, and a page around that is of the site itself.
import assert from 'node:assert/strict';
import { assignment, inFrame, world } from '../embed.mjs';
import { message } from '../frame.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { test } from '../tried-again.mjs';
import { appears, press, says } from '../words.mjs';

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
