// Emoji: their font is downloaded once, when the first text with an emoji appears. Then all texts show emoji.
import assert from 'node:assert/strict';
import { linkTo } from '../link.mjs';
import { look, photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, choose, press, says, words } from '../words.mjs';

const FONT = /\/noto_emoji\.\w+\.ttf$/;
const SETTLING = 1_500;

const worldOf = (title, task) =>
  linkTo('w', {
    format: 'robotran-world',
    version: 2,
    title,
    task,
    paper: { width: 80, height: 60 },
    robots: [{ start: { x: 20, y: 15, heading: 0 } }],
  });

const fonts = (fetched) => fetched.filter((address) => FONT.test(address));

/** A screenshot of `tag`, cropped to the given size. */
async function pictureOf(page, tag, { width = Infinity, height = Infinity } = {}) {
  const place = await words(page, tag).first().boundingBox();
  await page.waitForTimeout(SETTLING);
  const clip = { x: place.x, y: place.y, width: Math.min(place.width, width), height: Math.min(place.height, height) };
  return (await look(page, () => page.screenshot({ clip }))).toString('base64');
}

/** Without a font all emoji are drawn as the same box. */
function assertDrawn(pictures, where) {
  assert.equal(new Set(pictures).size, pictures.length, `${where}: emoji that look alike`);
}

async function writeInstead(page, text) {
  await page.keyboard.press('Control+a');
  // Text inserted without a key, such as from an emoji picker, does not wait until the previous key is processed.
  await page.waitForFunction(() => {
    const { value, selectionStart, selectionEnd } = document.activeElement;
    return selectionStart === 0 && selectionEnd === value.length;
  });
  await page.keyboard.insertText(text);
}

test('emoji are drawn in programs and dialogs, in a font that only they have fetched', () =>
  onPage(TABLET, async ({ page, troubles, fetched }) => {
    await press(page, 'program');
    await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
    await writeInstead(page, '// ¿Dónde está? größer →\n');
    await page.waitForTimeout(SETTLING);
    assert.deepEqual(fonts(fetched), [], 'fetched for letters');

    const lines = [];
    for (const emoji of ['🚀', '🐢', '⭐']) {
      // The caret blinks on the line below, outside of the screenshot.
      await writeInstead(page, `// ${emoji}\n`);
      await says(page, 'program', new RegExp(emoji));
      lines.push(await pictureOf(page, 'program', { height: 24 }));
    }
    assertDrawn(lines, 'the program');
    await writeInstead(page, '// 🚀 👍🏽 🇪🇸 ❤️ 1️⃣ 👩‍💻\nforward 5 // 🤖\n');
    await photograph(page, 'emoji-program');

    await choose(page, 'work-menu', 'work-rename');
    await appears(page, 'document-text');
    const names = [];
    for (const emoji of ['🚀', '🐢']) {
      await writeInstead(page, `${emoji} with Ada`);
      // Excludes the caret at the end of the name.
      names.push(await pictureOf(page, 'document-text', { width: 44 }));
    }
    await photograph(page, 'emoji-name');
    assertDrawn(names, 'the name of the work');
    assert.equal(fonts(fetched).length, 1, fonts(fetched).join());
    assert.deepEqual(troubles, []);
  }));

test('emoji are drawn in the title and the task of a link', () =>
  onPage({ ...TABLET, address: worldOf('🚀', 'Drive to the 🏁!') }, async ({ page, troubles, fetched }) => {
    await says(page, 'task-text', /Drive to the/);
    const titles = [await pictureOf(page, 'task-title', { width: 40 })];
    await photograph(page, 'emoji-task');
    await page.evaluate(
      (fragment) => {
        location.hash = fragment;
      },
      worldOf('🐢', 'Slowly.'),
    );
    await says(page, 'task-text', /Slowly/);
    titles.push(await pictureOf(page, 'task-title', { width: 40 }));
    assertDrawn(titles, 'the title');
    assert.equal(fonts(fetched).length, 1);
    assert.deepEqual(troubles, []);
  }));
