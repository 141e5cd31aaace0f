// Breakpoints, steps and failures of Robolang and Java programs in the built page.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { choose, press, reports, says, tap } from '../words.mjs';

const MAIN =
  'public class Program {\n    public static void main(String[] args) {\n        int rounds = 0;\n        while (rounds < 5) {\n' +
  '            rounds = Helper.next(rounds);\n        }\n        rounds = 1 / (rounds - 5);\n    }\n}\n';
const HELPER =
  'class Helper {\n    static int next(int number) {\n        number = number + 1;\n        return number;\n    }\n}\n';

/** Replaces the current file by `text`. */
async function replace(page, text) {
  await press(page, 'program');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

/**
 * The inline diagnostic under `line` that says why the run failed there. The status and the brick show it, too, under
 * other tags.
 */
const failureNote = (page, line) =>
  page.locator('#robotran-words div:not([data-tag])').and(page.getByText(new RegExp(`^Line ${line}: `)));

/** Moves the caret to `line` of the current file. */
async function goToLine(page, line) {
  await page.keyboard.press('Control+Home');
  for (let step = 1; step < line; step++) await page.keyboard.press('ArrowDown');
}

test('a Java program of one file stops at its breakpoint, is stepped through, and shows where it could not go on', () =>
  // No line goes on in a second row, where the caret would stop on its way down.
  onPage({ ...TABLET, width: 1440, hasTouch: true }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await replace(page, MAIN.replace('Helper.next(rounds)', 'rounds + 1'));
    await goToLine(page, 5);
    await page.keyboard.press('F9');
    await press(page, 'run');
    await says(page, 'status', /Paused at line 5/);
    await photograph(page, 'java-breakpoint');
    await press(page, 'stop');
    await reports(page, (report) => report.status === 'ended');

    await press(page, 'step');
    await says(page, 'status', /Paused at line 3/);
    await photograph(page, 'java-first-step');
    await press(page, 'step');
    await says(page, 'status', /Paused at line 4/);
    await press(page, 'stop');

    await press(page, 'program');
    await goToLine(page, 5);
    await page.keyboard.press('F9');
    await tap(page, 'run');
    await says(page, 'status', /Line 7: /);
    await failureNote(page, 7).waitFor({ state: 'attached' });
    await photograph(page, 'java-failure');
    await press(page, 'program');
    await page.keyboard.press('Control+End');
    await page.keyboard.type('//');
    await failureNote(page, 7).waitFor({ state: 'detached' });
    assert.deepEqual(troubles, []);
  }));

test('a Java program of several files stops in the file with the breakpoint', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await replace(page, MAIN);
    await choose(page, 'add-program', 'new-class');
    await replace(page, HELPER);
    await goToLine(page, 3);
    await page.keyboard.press('F9');
    await press(page, 'file-0');
    await press(page, 'run');
    await says(page, 'status', /Paused at line 3/);
    await says(page, 'program', /class Helper/);
    await photograph(page, 'java-breakpoint-in-class');
    assert.deepEqual(troubles, []);
  }));

test('the line that a Robolang program could not go on at is marked and brought into sight', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await replace(page, `var x = 0\n${'beep\n'.repeat(40)}show 10 / x`);
    await page.keyboard.press('Control+Home');
    await press(page, 'run');
    await failureNote(page, 42).waitFor({ state: 'attached' });
    await photograph(page, 'robolang-failure');
    const { bottom } = await failureNote(page, 42).evaluate((note) => note.getBoundingClientRect().toJSON());
    assert.ok(bottom < TABLET.height, `the note ends at ${bottom}`);
    await press(page, 'program');
    await page.keyboard.type('//');
    await failureNote(page, 42).waitFor({ state: 'detached' });
    assert.deepEqual(troubles, []);
  }));
