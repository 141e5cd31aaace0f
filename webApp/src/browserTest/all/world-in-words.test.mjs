// A pupil who does not see the sheet: with the picture covered, the corridor and three lessons are solved through the accessibility HTML and keys alone.
// Each program is made of the sentences that were told. What was said and done is written down beside the pictures.
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

    hears,

    /** Reads of the lesson's panel what has to do with `pattern`. */
    async reads(pattern) {
      const read = await page.waitForFunction(
        (source) => {
          const texts = [...document.querySelectorAll('#robotran-words *')].filter((element) => element.children.length === 0);
          return texts.map((element) => element.textContent || element.ariaLabel || '').find((text) => new RegExp(source).test(text));
        },
        pattern.source,
        { timeout: PATIENCE },
      );
      lines.push(`reads: ${await read.jsonValue()}`);
    },

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

const SIDES = { 'to the right': 0, up: 90, 'to the left': 180, down: -90 };
const OF_ARROWS = { 'to the right': 'ArrowRight', up: 'ArrowUp', 'to the left': 'ArrowLeft', down: 'ArrowDown' };

/** Between -180 and 180 degrees. */
const turned = (degrees) => ((((degrees + 180) % 360) + 360) % 360) - 180;

/** The heading in degrees of a direction on the sheet, such as `up, 30 degrees further to the right`. */
function headingOf(direction) {
  const [side, further] = direction.split(', ');
  const [, degrees, aside] = /^([0-9]+) degrees further (.+)$/.exec(further ?? '') ?? [];
  if (!degrees) return SIDES[side];
  return SIDES[side] + Number(degrees) * Math.sign(turned(SIDES[aside] - SIDES[side]));
}

/** By how much one has to turn, to the left if it is positive. */
function turnOf(way) {
  if (way === 'straight ahead') return 0;
  if (way === 'straight behind') return 180;
  const [, degrees, side] = /([0-9]+) degrees to the (left|right)/.exec(way);
  return side === 'left' ? Number(degrees) : -Number(degrees);
}

/** A pupil's note of what the robot will have done: lines of a program, and where it will be then. */
class Plan {
  lines = [];
  x = 0;
  y = 0;

  constructor(heading) {
    this.heading = heading;
  }

  forward(length) {
    this.lines.push(`forward ${length}`);
    this.x += Number(length) * Math.cos((this.heading * Math.PI) / 180);
    this.y += Number(length) * Math.sin((this.heading * Math.PI) / 180);
  }

  turn(degrees) {
    const whole = Math.round(turned(degrees));
    if (whole !== 0) this.lines.push(`turn ${whole > 0 ? 'left' : 'right'} ${Math.abs(whole)}`);
    this.heading += whole;
  }

  /** Drives to a place without drawing. */
  goTo(x, y) {
    const length = Math.round(Math.hypot(x - this.x, y - this.y));
    if (length === 0) return;
    this.turn((Math.atan2(y - this.y, x - this.x) * 180) / Math.PI - this.heading);
    this.forward(length);
  }

  /** Drives along `steps`, such as `4 times 20 cm and 90 degrees to the left`. */
  draw(steps) {
    const [, times, parts] = /^(?:([0-9]+) times )?(.+)$/.exec(steps);
    const round = this.lines.length;
    for (let done = 0; done < Number(times ?? 1); done++) {
      this.lines.length = round;
      for (const part of parts.split(/, | and /)) {
        const [, length] = /^([0-9.]+) cm$/.exec(part) ?? [];
        if (length) this.forward(length);
        else this.turn(turnOf(part));
      }
    }
    if (times) this.lines.splice(round, Infinity, `repeat ${times} times`, ...this.lines.slice(round), 'end');
  }
}

/** The program that draws what `where` tells of the drawing. */
function drawingOf(where) {
  const looks = headingOf(/It looks ([^.]+)\./.exec(where)[1]);
  const plan = new Plan(looks);
  const told = where.matchAll(/drawing begins (where the robot is|([0-9.]+) cm away, ([^,]+),) and goes ([^:]+): (.+?)\.(?= |$)/g);
  for (const [, , away, way, direction, steps] of told) {
    const towards = away ? ((looks + turnOf(way)) * Math.PI) / 180 : 0;
    plan.goTo(Number(away ?? 0) * Math.cos(towards), Number(away ?? 0) * Math.sin(towards));
    plan.turn(headingOf(direction) - plan.heading);
    plan.lines.push('pen down');
    plan.draw(steps);
    plan.lines.push('pen up');
  }
  assert.ok(plan.lines.length > 0, `Nobody tells what to draw: ${where}`);
  return plan.lines.join('\n');
}

/** The program for a way to something that is felt: what is ahead, and what the goals say. */
function feeling(where) {
  assert.match(where, /Ahead: a wall/);
  const [, back] = /Drive back ([0-9]+) cm\./.exec(where) ?? [];
  assert.ok(back, `Nobody tells how far to drive back: ${where}`);
  const beep = /Play a tone\./.test(where) ? '\nbeep' : '';
  return `start forward\nwait until left bumper or right bumper\nbackward ${back}${beep}`;
}

const IS_MET = /The goal is met\.|All goals are met\./;

/** Asks, writes the program that follows from what was told, runs it and listens, until the goals are met. */
async function solve(pupil, programFor = wayTo) {
  for (let attempt = 1; attempt <= 4; attempt++) {
    // Before each run the robot stands where it begins.
    const where = await pupil.asks('F8', /Goal/);
    await pupil.writes(programFor(where));
    const story = await pupil.runs();
    if (IS_MET.test(story)) return;
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

/**
 * Opens `lesson` of `strand`, whose task says `task`, with the picture covered, for a pupil to solve in `solving`; the transcript is kept under
 * `name`.
 */
const inLesson = (strand, lesson, task, name, solving) =>
  onPage(TABLET, async ({ page, troubles }) => {
    await cover(page);
    await tellsRuns(page);
    await activate(page, 'menu');
    await activate(page, 'menu-map');
    await activate(page, `go-to-${strand}`);
    await activate(page, `lesson-${lesson}`);
    await appears(page, 'program');
    await enters(page);
    const pupil = pupilAt(page);
    await pupil.reads(task);
    await solving(pupil, page).finally(() => writeDown(name, pupil.lines));
    assert.deepEqual(troubles, []);
  });

test('the first lesson is solved by what is told of it, and the sheet is explored by keys', () =>
  inLesson('drive', 'first-drive', /Drive there/, 'lesson-in-words', async (pupil, page) => {
    let here = await pupil.asks('Shift+F8', /cm up/);
    assert.match(here, /20 cm from the left, 15 cm up: the robot/);
    // One step of an arrow is 5 cm.
    const way = /To the goal: ([^.]+)\./.exec(here)[1].split(' and ');
    for (const step of way) {
      const [, length, side] = /([0-9.]+) cm (.+)/.exec(step);
      for (let gone = 5; gone <= Math.round(Number(length)); gone += 5) here = await pupil.asks(OF_ARROWS[side], /cm up/);
    }
    assert.match(here, /: a place to reach\./);
    pupil.note('presses Escape');
    await page.keyboard.press('Escape');
    await disappears(page, 'exploring-cross');
    await solve(pupil);
  }));

test('a house is drawn by what is told of the drawing', () =>
  inLesson('drive', 'house', /Draw the whole house/, 'house-in-words', (pupil) => solve(pupil, drawingOf)));

test('the robot knocks at a door that nobody has measured, in both places of the lesson', () =>
  inLesson('decide', 'knock', /bumps into the door/, 'knock-in-words', async (pupil, page) => {
    await solve(pupil, feeling);
    pupil.note('presses "Try it there"');
    await activate(page, 'try-elsewhere');
    assert.match(await pupil.hears(/program ended/), IS_MET);
  }));

test('the keys work while nothing in the page has the focus', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await appears(page, 'program');
    const pupil = pupilAt(page);
    await pupil.asks('F8', /The robot is/);
    await page.evaluate(() => document.activeElement?.blur());
    await pupil.asks('Shift+F8', /cm up: /);
    await page.evaluate(() => document.activeElement?.blur());
    await page.keyboard.press('Escape');
    await page.locator('canvas').first().click({ position: { x: 900, y: 200 } });
    await page.keyboard.press('Control+Enter');
    await appears(page, 'pause');
    await pupil.asks('Control+F8', /program/);
    assert.deepEqual(troubles, []);
  }));
