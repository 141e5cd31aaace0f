// Text input in the built page: letters, dead keys, input methods, the clipboard, and keys faster than the frames.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isKept } from '../kept.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { PATIENCE, programText, writeProgram } from '../words.mjs';

test('accents that an input method or a dead key makes are written once', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, '');
    const keyboard = await page.context().newCDPSession(page);
    const compose = async (...stages) => {
      for (const text of stages)
        await keyboard.send('Input.imeSetComposition', {
          text,
          selectionStart: text.length,
          selectionEnd: text.length,
        });
      await keyboard.send('Input.insertText', { text: stages.at(-1) });
    };
    await page.keyboard.type('// ma');
    await compose('~', 'ñ');
    await page.keyboard.type('ana');
    await compose('にほ', '日本');
    await isKept(page, 'mañana日本');
    assert.match(await programText(page), /\/\/ mañana日本$/);
    assert.deepEqual(troubles, []);
  }));

test('text is copied, cut and pasted by keys, within the program and from elsewhere', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'beep');
    await copyAndPaste(page);
    await reads(page, 'beep\nbeep\nbeep\nbeep');
    assert.deepEqual(troubles, []);
  }));

test('keys that are quicker than pictures find done what the ones before them did', () =>
  onPage({ ...TABLET, prepare: slowPictures }, async ({ page, troubles }) => {
    await writeProgram(page, 'repeat 2 times');
    await page.evaluate(() => globalThis.holdPictures(true));
    for (const key of ['Enter', 'x', 'y', 'ArrowLeft', 'z', 'Backspace', 'Shift+ArrowRight', 'w'])
      await page.keyboard.press(key);
    await page.evaluate(() => globalThis.holdPictures(false));
    await reads(page, 'repeat 2 times\n  xw');
    await page.keyboard.press('Escape');
    await writeProgram(page, 'beep');
    await page.evaluate(() => globalThis.holdPictures(true));
    await copyAndPaste(page);
    await page.evaluate(() => globalThis.holdPictures(false));
    await reads(page, 'beep\nbeep\nbeep\nbeep');
    assert.deepEqual(troubles, []);
  }));

/** With one word in the program: cuts, pastes and copies until the word is there four times. */
async function copyAndPaste(page) {
  const keys = [
    'Control+a',
    'Control+x',
    'Control+v',
    'Enter',
    'Control+v',
    'Control+a',
    'Control+c',
    'Control+End',
    'Enter',
    'Control+v',
  ];
  for (const key of keys) await page.keyboard.press(key);
}

/** Waits until the focused field contains `text`. */
const reads = (page, text) =>
  page
    .waitForFunction((wanted) => document.activeElement.value === wanted, text, { timeout: PATIENCE })
    .catch(async () => assert.equal(await programText(page), text));

/** Runs in the page, so that a test can delay its frames. */
function slowPictures() {
  const ask = globalThis.requestAnimationFrame.bind(globalThis);
  const held = [];
  let holds = false;
  globalThis.requestAnimationFrame = (callback) => (holds ? held.push(callback) : ask(callback));
  globalThis.holdPictures = (now) => {
    holds = now;
    if (!now) for (const callback of held.splice(0)) ask(callback);
  };
}
