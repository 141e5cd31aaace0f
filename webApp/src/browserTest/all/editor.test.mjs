// The editor of the built page: completions, fixes, and the size limit of programs.
import assert from 'node:assert/strict';
import { isKept } from '../kept.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import {
  appears,
  choose,
  disappears,
  isSaid,
  PATIENCE,
  placeOf,
  press,
  programText,
  says,
  tap,
  words,
  writeProgram,
} from '../words.mjs';

const FULL = 200_000;
const LINE = 'forward 20\n';

/** Waits until the program equals `text`. */
async function reads(page, text) {
  const end = Date.now() + PATIENCE;
  while ((await programText(page)) !== text && Date.now() < end) await page.waitForTimeout(100);
  assert.equal(await programText(page), text);
}

/** Pastes `text` into the program through the clipboard. */
async function paste(page, text) {
  await page.evaluate((copied) => navigator.clipboard.writeText(copied), text);
  await page.keyboard.press('Control+v');
}

/** Opens the editor's menu by touch or mouse, as `point` does, and requests completions. */
async function askWhatCouldCome(page, point) {
  await point(page, 'editor-more');
  await point(page, 'tool-complete');
}

for (const [how, point] of [
  ['a mouse', press],
  ['a finger', tap],
]) {
  test(`what could come where the caret is is offered to ${how}, chosen and written over`, () =>
    onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
      await writeProgram(page, 'turn ');
      await askWhatCouldCome(page, point);
      await appears(page, 'completions');
      await photograph(page, `completions-by-${how.split(' ')[1]}`);
      const { x, y } = await placeOf(page, 'completions');
      const first = await words(page, 'completions').evaluate((list) => list.getBoundingClientRect().top + 22);
      assert.ok(first < y + 1);
      await (point === tap ? page.touchscreen.tap(x, first) : page.mouse.click(x, first));
      await reads(page, 'turn left 90');
      await page.keyboard.type('45');
      await reads(page, 'turn left 45');
      await page.keyboard.type(' // a quarter');
      await askWhatCouldCome(page, point);
      await appears(page, 'no-completions');
      assert.deepEqual(troubles, []);
    }));

  test(`a fix says what it does, does it for ${how}, and one writes on`, () =>
    onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
      await writeProgram(page, 'forward5');
      await says(page, 'fix', /Put a space: forward 5/);
      await photograph(page, 'fix-space');
      await point(page, 'fix');
      await disappears(page, 'fix');
      await page.keyboard.type('0');
      await reads(page, 'forward 50');

      await choose(page, 'add-program', 'new-java');
      await press(page, 'program');
      await page.keyboard.press('Control+a');
      const java = (end) =>
        'public class Program {\n    public static void main(String[] args) {\n        int rounds = 0;\n' +
        `        for (int i = 0; i < 3; i++) {\n            rounds = rounds + i${end}\n        }\n    }\n}\n`;
      await page.keyboard.insertText(java(''));
      await isSaid(page, /Line 5: Put a ";" at the end/);
      await says(page, 'fix', /Add ;/);
      await point(page, 'fix');
      await reads(page, java(';'));
      await page.keyboard.type('//');
      await reads(page, `${java(';')}//`);
      assert.deepEqual(troubles, []);
    }));
}

test('a word that needs a value comes with one to write over', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, '');
    await page.keyboard.type('forw');
    await appears(page, 'completions');
    await page.keyboard.press('Enter');
    await page.keyboard.type('35');
    await reads(page, 'forward 35');
    await page.keyboard.press('Enter');
    await page.keyboard.type('tur');
    await appears(page, 'completions');
    await page.keyboard.press('Enter');
    await appears(page, 'completions');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await reads(page, 'forward 35\nturn right 90');
    assert.deepEqual(troubles, []);
  }));

test('what is too long for a program is refused at once, and what fits is written in without waiting', () =>
  onPage({ ...TABLET, permissions: ['clipboard-read', 'clipboard-write'] }, async ({ page, troubles }) => {
    await writeProgram(page, 'beep');
    for (const length of [500_000, 5_000_000]) {
      await page.evaluate((copied) => navigator.clipboard.writeText(copied), LINE.repeat(length / LINE.length));
      await page.keyboard.press('Control+v');
      await says(page, 'notice-text', /too long/);
      await press(page, 'notice-close');
      await press(page, 'program');
      await reads(page, 'beep');
    }
    await page.keyboard.press('Control+a');
    const text = LINE.repeat(FULL / LINE.length - 1);
    await paste(page, text);
    await page.keyboard.type('beep');
    await isKept(page, '"beep"');
    const times = [];
    for (let key = 0; key < 20; key++) {
      const begin = Date.now();
      await page.keyboard.press(key % 2 ? 'Backspace' : '5');
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
      times.push(Date.now() - begin);
    }
    times.sort((one, other) => one - other);
    // The limit includes the time that a loaded machine needs to draw. Before the fix each key took a minute.
    assert.ok(times[10] < 1_000, `keys take ${times}`);
    await reload(page);
    await press(page, 'program');
    await page.keyboard.press('Control+End');
    await page.waitForFunction(() => document.activeElement.value?.endsWith('20\nbeep'));
    assert.deepEqual(troubles, []);
  }));
