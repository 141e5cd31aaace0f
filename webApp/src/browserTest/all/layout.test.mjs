// The layout of the built page on screens of all sizes with touch, and that it does not shift.
import assert from 'node:assert/strict';
import { loadAgain, photograph } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, placeOf, press, reports, says, words, writeProgram } from '../words.mjs';

const PRESSABLE = [
  'menu',
  'learn',
  'worlds',
  'edit-world',
  'tab-program',
  'tab-world',
  'tab-brick',
  'run',
  'pause',
  'step',
  'stop',
  'run-more',
  'sound',
  'timeline',
  'mark-previous',
  'mark-next',
  'world',
  'sheet-whole',
  'sheet-show',
  'sheet-3d',
  'goal-chip',
  'brick',
  'brick-run',
  'brick-view',
  'brick-prgm',
  'brick-on_off',
  'drawer-variables',
  'drawer-goals',
  'program',
  'undo',
  'editor-more',
  'program-0',
];

const touched = (width, height) => ({ width, height, hasTouch: true });

async function tap(page, tag) {
  const { x, y } = await placeOf(page, tag);
  await page.touchscreen.tap(x, y);
}

const isThere = async (page, tag) => (await words(page, tag).count()) > 0;

/** The position of each of `tags` on the page: { left, top, right, bottom } in CSS pixels. */
const boxesOf = (page, tags) =>
  page.evaluate(
    (wanted) =>
      Object.fromEntries(
        wanted.flatMap((tag) => {
          const found = document.querySelectorAll(`#robotran-words [data-tag="${tag}"]`);
          if (found.length !== 1) return [];
          const { left, top, right, bottom } = found[0].getBoundingClientRect();
          return [[tag, { left, top, right, bottom }]];
        }),
      ),
    tags,
  );

const overlap = (one, other) =>
  one.left < other.right - 1 && other.left < one.right - 1 && one.top < other.bottom - 1 && other.top < one.bottom - 1;

/** Fails if anything pressable in `before` has moved. */
async function assertStill(page, before, moment) {
  await page.waitForTimeout(700);
  const now = await boxesOf(page, Object.keys(before));
  for (const [tag, box] of Object.entries(before)) {
    const there = now[tag];
    assert.ok(there, `${moment}: ${tag} is gone`);
    for (const side of Object.keys(box))
      assert.ok(Math.abs(there[side] - box[side]) <= 1, `${moment}: ${tag} moved ${JSON.stringify([box, there])}`);
  }
}

/** Writes `text` as the program. The world is shown before and after. */
async function write(page, text) {
  const alone = await isThere(page, 'tab-program');
  if (alone) await tap(page, 'tab-program');
  await writeProgram(page, text);
  if (alone) {
    await tap(page, 'tab-world');
    await appears(page, 'world');
  }
}

async function chooseSquareWorld(page) {
  if (await isThere(page, 'worlds')) {
    await tap(page, 'worlds');
  } else {
    await tap(page, 'menu');
    await tap(page, 'menu-worlds');
  }
  await appears(page, 'world-square');
  // On a phone it is at the lower edge.
  await press(page, 'world-square');
  await appears(page, 'goal-chip');
}

for (const [width, height] of [
  [1180, 820],
  [820, 1180],
  [412, 915],
  [1366, 768],
]) {
  test(`nothing that can be pressed moves while a program runs, at ${width} x ${height}`, () =>
    onPage(touched(width, height), async ({ page, troubles }) => {
      await chooseSquareWorld(page);
      if (await isThere(page, 'tab-world')) await tap(page, 'tab-world');
      await write(page, 'repeat 1000 times\nforward 3\nbackward 3\nend');
      await placeOf(page, 'run');
      const before = await boxesOf(page, PRESSABLE);
      for (const tag of ['run', 'pause', 'stop', 'timeline', 'world', 'goal-chip'])
        assert.ok(before[tag], `${tag} is there`);
      await tap(page, 'run');
      await reports(page, (report) => report.status === 'running');
      await assertStill(page, before, 'running');
      await tap(page, 'pause');
      await says(page, 'status', /Paused/);
      await assertStill(page, before, 'paused');
      await tap(page, 'pause');
      await tap(page, 'stop');
      await says(page, 'status', /Stopped/);
      await assertStill(page, before, 'stopped');
      await write(page, 'var zero = 0\nforward 2\nshow 5 / zero');
      await tap(page, 'run');
      await says(page, 'brick-hint', /Line 3/);
      await assertStill(page, before, 'failed');
      await photograph(page, `layout-failed-${width}x${height}`);
      const hint = (await boxesOf(page, ['brick-hint']))['brick-hint'];
      const after = await boxesOf(page, PRESSABLE);
      for (const tag of ['brick', 'brick-run', 'goal-chip', 'run', 'sheet-show'].filter((one) => after[one])) {
        assert.ok(
          !overlap(hint, after[tag]),
          `${tag} and why the program failed lie over each other: ${JSON.stringify([hint, after[tag]])}`,
        );
      }
      assert.ok(hint.top >= 0 && hint.left >= 0 && hint.right <= width && hint.bottom <= height, JSON.stringify(hint));
      for (const [tag, box] of Object.entries(after)) {
        assert.ok(
          box.left >= -1 && box.top >= -1 && box.right <= width + 1 && box.bottom <= height + 1,
          `${tag} is cut: ${JSON.stringify(box)}`,
        );
      }
      const { brick } = after;
      if (brick)
        assert.ok(
          Math.abs((brick.bottom - brick.top) / (brick.right - brick.left) - 424 / 264) < 0.02,
          'the brick is whole',
        );
      assert.deepEqual(troubles, []);
    }));
}

test('a program that ends without its goal says so, once', () =>
  onPage(touched(1366, 768), async ({ page, troubles }) => {
    await chooseSquareWorld(page);
    await write(page, 'forward 2');
    await tap(page, 'run');
    await says(page, 'status', /Program ended\. Goal not met\./);
    await says(page, 'goal-chip', /0 of 1 goals met/);
    await tap(page, 'goal-chip');
    await appears(page, 'goal');
    const goal = await words(page, 'goal')
      .first()
      .evaluate((element) => element.outerHTML);
    assert.equal(goal.match(/not met/g)?.length, 1, goal);
    await photograph(page, 'layout-goal-not-met');
    assert.deepEqual(troubles, []);
  }));

test('a tutorial leaves program and world in sight, on a tablet across and upright', async () => {
  await onPage(touched(1180, 820), async ({ page, troubles }) => {
    await tap(page, 'learn');
    await appears(page, 'tutorial');
    await placeOf(page, 'world');
    const { tutorial, world, 'editor-more': tools } = await boxesOf(page, ['tutorial', 'world', 'editor-more']);
    assert.ok(world.right - world.left > 500, JSON.stringify(world));
    assert.ok(tools.right <= world.left && tools.right - tools.left >= 47, JSON.stringify(tools));
    assert.ok(tutorial.bottom <= tools.top && tutorial.right <= world.left, JSON.stringify([tutorial, tools]));
    await photograph(page, 'layout-tutorial-across');
    assert.deepEqual(troubles, []);
  });
  await onPage(touched(820, 1180), async ({ page, troubles }) => {
    await tap(page, 'learn');
    await appears(page, 'tutorial');
    await placeOf(page, 'world');
    const { tutorial, world, program } = await boxesOf(page, ['tutorial', 'world', 'program']);
    assert.ok(
      tutorial.bottom <= world.top + 1 && world.bottom <= program.top,
      JSON.stringify([tutorial, world, program]),
    );
    assert.ok(world.bottom - world.top > 240 && program.bottom - program.top > 200, JSON.stringify([world, program]));
    await photograph(page, 'layout-tutorial-upright');
    await tap(page, 'run');
    await reports(page, (report) => report.status !== 'idle');
    for (const tag of ['tutorial', 'world', 'program', 'run']) assert.ok(await isThere(page, tag), tag);
    assert.deepEqual(troubles, []);
  });
});

test('the brick is whole by one touch, after a reload, too, and a finger measures on the sheet', () =>
  onPage(touched(820, 1180), async ({ page, troubles }) => {
    await appears(page, 'brick-run');
    assert.ok(!(await isThere(page, 'brick')), 'the brick is small at first');
    await tap(page, 'brick-size');
    await appears(page, 'brick');
    await loadAgain(page);
    await appears(page, 'brick');
    await tap(page, 'sheet-measure');
    await says(page, 'measured', /^[\d.]+ cm, turn (left|right) [\d.]+ degrees$/);
    const measured = () => words(page, 'measured').evaluate((element) => element.outerHTML);
    const before = await measured();
    const { x, y } = await placeOf(page, 'world');
    await page.touchscreen.tap(x, y);
    await page.waitForTimeout(700);
    assert.notEqual(await measured(), before, 'a tap moves the end of the ruler');
    await photograph(page, 'layout-measuring');
    await tap(page, 'sheet-measure');
    await page.waitForTimeout(700);
    assert.ok(!(await isThere(page, 'measured')), 'a second touch takes the ruler away');
    assert.deepEqual(troubles, []);
  }));
