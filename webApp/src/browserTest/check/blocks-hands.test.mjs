// Blocks in the built page, as a keyboard and a screen reader meet them: the clipboard, and the tree.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { savedProjects } from '../kept.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { appears, disappears, PATIENCE, press, says, words, writeProgram } from '../words.mjs';

/** Waits until a screen reader is told that `tag` has the focus. */
const isAt = (page, tag) =>
  page.waitForFunction(
    (wanted) => {
      const id = document.querySelector('canvas').getAttribute('aria-activedescendant');
      return document.getElementById(id)?.dataset.tag === wanted;
    },
    tag,
    { timeout: PATIENCE },
  );

/** Shows the program `text` in blocks, with the cursor at the first one. */
async function showInBlocks(page, text) {
  await writeProgram(page, text);
  await press(page, 'view-switch');
  await press(page, 'view-blocks');
  await appears(page, 'block-0');
  await words(page, 'block-0').evaluate((element) => element.click());
  await isAt(page, 'block-0');
}

/** Waits until a saved project has a program with these lines. */
async function isProgram(page, lines) {
  const closed = (text) => text.replaceAll(/\s/g, '');
  const end = Date.now() + PATIENCE;
  for (;;) {
    const works = await savedProjects(page);
    if (works.some((text) => closed(text).includes(closed(`"text":${JSON.stringify(lines)}`)))) return;
    assert.ok(Date.now() < end, `${lines} is not in ${works}`);
    await page.waitForTimeout(100);
  }
}

test('blocks are copied as text, and text from elsewhere is pasted as blocks', () =>
  onPage({ ...TABLET, permissions: ['clipboard-read', 'clipboard-write'] }, async ({ page, troubles }) => {
    await showInBlocks(page, 'beep');
    await page.keyboard.press('Control+c');
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), 'beep\n');
    await page.keyboard.press('Control+v');
    await isProgram(page, ['beep', 'beep']);
    await page.evaluate(() => navigator.clipboard.writeText('repeat 2 times\n  dance\nend'));
    await page.keyboard.press('Control+v');
    await isProgram(page, ['beep', 'beep', 'repeat 2 times', '  dance', 'end']);
    await page.keyboard.press('Control+x');
    await isProgram(page, ['beep', 'beep']);
    await press(page, 'block-0');
    await press(page, 'block-more');
    await press(page, 'actions-more');
    // It is further down, where a screen reader finds it.
    await words(page, 'action-paste').evaluate((element) => element.click());
    await isProgram(page, ['beep', 'repeat 2 times', '  dance', 'end', 'beep']);
    assert.deepEqual(troubles, []);
  }));

test('a screen reader finds a tree, hears the block that the arrows lead to, and what an edit has done', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await showInBlocks(page, 'repeat 2 times\nbeep\nbuzz');
    const tree = await words(page, 'blocks').evaluate((element) => ({
      role: element.getAttribute('role'),
      owned: element.getAttribute('aria-owns').split(' ').length,
    }));
    assert.equal(tree.role, 'tree');
    assert.ok(tree.owned > 6, `${tree.owned}`);
    const attributes = (tag) =>
      words(page, tag).evaluate((element) =>
        ['role', 'aria-level', 'aria-posinset', 'aria-setsize', 'aria-expanded'].map((name) => element.getAttribute(name)),
      );
    assert.deepEqual(await attributes('block-0'), ['treeitem', '1', '1', '1', 'true']);
    assert.deepEqual(await attributes('block-1'), ['treeitem', '2', '1', '2', null]);
    const label = (tag) => words(page, tag).getAttribute('aria-label');
    assert.match(await label('block-0'), /^repeat 2 times, 2 blocks inside\./); // It has no end.
    assert.equal(await label('block-1'), 'beep, in repeat 2 times');
    const actions = (tag) =>
      words(page, tag).evaluate((element) => {
        const labels = [];
        for (let next = element.nextElementSibling; next?.id.startsWith(`${element.id}-`); next = next.nextElementSibling) {
          labels.push(next.textContent);
        }
        return labels;
      });
    assert.ok((await actions('block-0')).length > 6);
    assert.deepEqual(await actions('block-2'), ['What you can do with this block']);
    await page.keyboard.press('ArrowDown');
    await isAt(page, 'block-1');
    await page.keyboard.press('Alt+ArrowDown');
    await says(page, 'blocks-said', /Moved: beep, 2 of 2 in repeat 2 times/);
    await page.keyboard.press('Enter');
    await appears(page, 'block-sheet');
    await page.keyboard.press('Escape');
    await disappears(page, 'block-sheet');
    assert.deepEqual(troubles, []);
  }));
