// A pupil who does not see the sheet: with the picture covered, a lesson and the corridor are solved through the accessibility HTML and keys alone, by
// what the page tells in words. What was said and done is written down beside the pictures.
import assert from 'node:assert/strict';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { linkTo } from '../link.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, PATIENCE, words } from '../words.mjs';

/** What a screen reader does to activate an element. */
async function activate(page, tag) {
  await appears(page, tag);
  await words(page, tag).first().evaluate((element) => element.click());
}

/** Presses Tab until the text of the program has the focus: then the browser's own field is active. */
async function goesToProgram(page) {
  const isThere = () => document.activeElement?.tagName === 'TEXTAREA' && !document.activeElement.dataset.tag;
  for (let pressed = 0; pressed < 80; pressed++) {
    if (await page.evaluate(isThere)) return;
    await page.keyboard.press('Tab');
    // The field gets the focus with one of the next frames.
    await page.waitForTimeout(150);
  }
  assert.fail('Tab does not lead to the program');
}

/** A pupil at the keyboard with a screen reader, who writes down what is heard and done. */
function pupilAt(page) {
  const lines = [];
  let heard = '';

  /** Waits until something new is said, and writes it down. */
  async function hears(pattern) {
    const said = await page.waitForFunction(
      ([before, source]) => {
        const now = document.querySelector('#robotran-words [data-tag="words-said"]')?.textContent ?? '';
        return now !== before && new RegExp(source, 's').test(now) ? now : null;
      },
      [heard, pattern.source],
      { timeout: PATIENCE },
    );
    heard = await said.jsonValue();
    lines.push(`hears: ${heard.trim()}`);
    return heard;
  }

  return {
    lines,

    note: (line) => lines.push(line),

    async asks(keys, pattern) {
      lines.push(`presses ${keys}`);
      await page.keyboard.press(keys);
      return hears(pattern);
    },

    /** Replaces the program by `text`, key by key. */
    async writes(text) {
      lines.push(`writes:\n${text.replace(/^/gm, '    ')}`);
      await goesToProgram(page);
      await page.keyboard.press('Control+a');
      await page.keyboard.press('Delete');
      for (const [number, line] of text.split('\n').entries()) {
        if (number > 0) await page.keyboard.press('Enter');
        await page.keyboard.type(line);
        await page.keyboard.press('Escape');
      }
    },

    async runs() {
      lines.push('presses Control+Enter');
      await page.keyboard.press('Control+Enter');
      return hears(/program (ended|was stopped|failed|still runs)/);
    },
  };
}

/** The turn and the way to the goal, as `where` tells them. */
function wayTo(where) {
  const [, centimetres, way] = /Its middle is ([0-9.]+) cm away, ([^.]+)\./.exec(where) ?? [];
  assert.ok(centimetres, `Nobody tells where the goal is: ${where}`);
  const [, degrees, side] = /([0-9]+) degrees to the (left|right)/.exec(way) ?? [];
  const behind = way === 'straight behind' ? 'turn left 180\n' : '';
  return `${degrees ? `turn ${side} ${degrees}\n` : behind}forward ${Math.round(Number(centimetres))}`;
}

/** Asks, writes a program, runs it and listens, until the goal is met. */
async function solve(pupil) {
  for (let attempt = 1; attempt <= 4; attempt++) {
    // Before each run the robot stands where it begins.
    const where = await pupil.asks('F8', /Goal/);
    await pupil.writes(wayTo(where));
    const story = await pupil.runs();
    if (/The goal is met\./.test(story)) return;
    pupil.note('begins again');
  }
  assert.fail(`not solved:\n${pupil.lines.join('\n')}`);
}

/** Covers the picture: what the pupil knows was told. */
const cover = (page) =>
  page.evaluate(() => document.querySelector('canvas').style.setProperty('opacity', '0', 'important'));

async function tellsRuns(page) {
  await activate(page, 'menu');
  await activate(page, 'menu-settings');
  await activate(page, 'tell-runs');
  await words(page, 'tell-runs').and(page.locator('[aria-checked="true"]')).waitFor({ state: 'attached' });
  await activate(page, 'settings-close');
  await disappears(page, 'settings-close');
}

/** Gives the focus to the first element, as whoever works with keys alone does: keys go to what has it. */
async function enters(page) {
  await page.locator('canvas').first().focus();
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => document.querySelector('canvas')?.hasAttribute('aria-activedescendant'), null, {
    timeout: PATIENCE,
  });
}

async function writeDown(name, lines) {
  const folder = process.env.PICTURES;
  if (!folder) return;
  await mkdir(folder, { recursive: true });
  await writeFile(path.join(folder, `${name}.txt`), `${lines.join('\n')}\n`);
}

test('the corridor is driven by what is told of it', async () => {
  const world = JSON.parse(await readFile(new URL('../../../../worlds/corridor.world.json', import.meta.url), 'utf8'));
  const project = {
    format: 'robotran-project',
    version: 1,
    world,
    robots: [
      { name: 'yellow', programs: [{ name: 'way.robo', language: 'robolang', view: 'text', text: ['forward 10'] }] },
    ],
  };
  await onPage({ ...TABLET, address: linkTo('p', project) }, async ({ page, troubles }) => {
    await cover(page);
    await tellsRuns(page);
    await enters(page);
    const pupil = pupilAt(page);
    await solve(pupil).finally(() => writeDown('corridor-in-words', pupil.lines));
    assert.deepEqual(troubles, []);
  });
});

test('the first lesson is solved by what is told of it, and the sheet is explored by keys', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await cover(page);
    await tellsRuns(page);
    await activate(page, 'menu');
    await activate(page, 'menu-map');
    await activate(page, 'lesson-first-drive');
    await appears(page, 'program');
    await enters(page);
    const pupil = pupilAt(page);
    const start = await pupil.asks('Shift+F8', /across/);
    assert.match(start, /20 across, 15 up: the robot/);
    await pupil.asks('ArrowRight', /25 across/);
    for (const place of ['30', '35', '40', '45', '50']) await pupil.asks('ArrowRight', new RegExp(`${place} across`));
    for (const place of ['20', '25', '30', '35', '40']) await pupil.asks('ArrowUp', new RegExp(`${place} up`));
    const flag = pupil.lines.at(-1);
    assert.match(flag, /50 across, 40 up: a place to reach/);
    pupil.note('presses Escape');
    await page.keyboard.press('Escape');
    await disappears(page, 'exploring-cross');
    await solve(pupil).finally(() => writeDown('lesson-in-words', pupil.lines));
    assert.deepEqual(troubles, []);
  }));
