// Builds programs from blocks in the page: with a finger, with a screen reader, and with keys.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { areBlocks, builderWith, fingerOn, keysOn, readerOn } from './blocks.mjs';
import { isKept } from './kept.mjs';
import { photograph } from './page.mjs';
import { onPage, TABLET } from './set-up.mjs';
import { appears, says, words } from './words.mjs';

/** Opens the first step of the tutorial in blocks. */
async function beginTutorial(page, hand) {
  await hand.press('menu');
  await hand.press('menu-learn');
  await hand.press('try-step');
  await appears(page, 'run-step');
  await showBlocks(page, hand);
}

async function showBlocks(page, hand) {
  await appears(page, 'view-switch');
  if ((await words(page, 'block-pane').count()) > 0) return;
  await hand.press('view-switch');
  await hand.press('view-blocks');
  await appears(page, 'block-pane');
}

/** Runs the step's program, and waits until its task is done. */
async function solves(page, hand) {
  await hand.press('run-step');
  await says(page, 'task-status', /done/);
}

async function goOn(page, hand) {
  await hand.press('next-step');
  await says(page, 'task-status', /^Your task$/);
  await showBlocks(page, hand);
}

/** The robot drives as fast as the machine allows, so that the test waits less for it. */
async function hurry(hand) {
  await hand.press('run-more');
  await hand.press('panel-speed-fastest');
  await hand.press('run-panel-close');
}

/** The solutions of the first five steps, from the programs that the steps begin with. */
async function buildFirstSteps(page, hand) {
  const builder = builderWith(page, hand);
  await beginTutorial(page, hand);
  await hurry(hand);
  await builder.setNumber(/^forward 20 cm/, /^20 cm/, 30);
  await builder.goTo(/^turn left/);
  await builder.add(['drive', 'move']);
  await builder.setNumber(/^forward 20 cm/, /^20 cm/, 25);
  await areBlocks(page, ['forward 30', 'turn left 90', 'forward 25']);
  await solves(page, hand);
  await photograph(page, 'blocks-step-1');
  await goOn(page, hand);

  await areBlocks(page, ['pen down', 'forward 20', 'pen up']);
  await builder.goTo(/^pen up/);
  await builder.add(['drive', 'move'], ['pen', 'pen'], ['drive', 'move'], ['pen', 'pen']);
  await builder.setNumber(/^forward 20 cm/, /^20 cm/, 10, 1);
  await builder.choose(/^pen down/, /^down/, /^up$/, 2);
  await areBlocks(page, ['pen down', 'forward 20', 'pen up', 'forward 10', 'pen down', 'forward 20', 'pen up']);
  await solves(page, hand);
  await goOn(page, hand);

  await builder.setNumber(/^repeat 4 times/, /^4/, 6);
  await builder.setNumber(/^turn left/, /^90/, 60);
  await solves(page, hand);
  await photograph(page, 'blocks-step-3');
  await goOn(page, hand);

  await builder.setNumber(/^side = side \+ 2|side \+ 2/, /^2/, 5);
  await solves(page, hand);
  await goOn(page, hand);

  await builder.act(/^for i from 1 to 3/, /step/);
  await builder.setNumber(/^for i from 1/, /^1/, 5);
  await builder.setNumber(/^for i from 5/, /^3/, 1);
  await builder.setNumber(/^for i from 5 to 1/, /^2/, -1);
  await builder.goTo(/^end of/i);
  await builder.add(['drive', 'move']);
  await builder.setNumber(/^forward 20/, /^20/, 45);
  await solves(page, hand);
  await photograph(page, 'blocks-step-5');
}

/** The solution of the maze, from nothing. */
async function buildMaze(page, hand) {
  const builder = builderWith(page, hand);
  await hand.press('leave-tutorial');
  await hand.press('worlds');
  await hand.press('world-maze');
  await says(page, 'task-title', /The maze/);
  await hand.press('add-program');
  await hand.press('new-robolang');
  await showBlocks(page, hand);
  await builder.add(
    ['drive', 'power-of-side', 'power-of-side'],
    ['control', 'repeat-forever'],
    ['drive', 'start-moving'],
    ['control', 'wait-until', 'else'],
    ['drive', 'move', 'turn'],
  );
  await builder.goTo(/^else/);
  await builder.add(['drive', 'move', 'turn']);
  await builder.choose(/^power left 5/, /^left/, /^right$/, 1);
  await builder.setNumber(/^power right 5/, /^5/, 1);
  await builder.choose(/^wait until/, /^left bumper/, /^left bumper and right bumper$/);
  await builder.choose(/^wait until/, /^and/, /^or$/);
  await builder.choose(/^wait until/, /^left,/, /^right$/, 0, 1);
  for (const [turn, distance, angle] of [
    [0, 4, 90],
    [0, 2, 25],
  ]) {
    await builder.choose(/^forward 20/, /^forward/, /^backward$/, turn);
    await builder.setNumber(/^backward 20/, /^20/, distance);
    if (angle !== 90) await builder.setNumber(/^turn left 90/, /^90/, angle, 1);
  }
  await photograph(page, 'blocks-maze');
  await hand.press('run');
  await says(page, 'goal-chip', /All goals met/);
}

test('a finger builds the solutions of the first five steps of the tutorial', () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    const hand = fingerOn(page);
    await buildFirstSteps(page, hand);
    await buildMaze(page, hand);
    assert.deepEqual(troubles, []);
  }));

test('a screen reader builds the same', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const hand = readerOn(page);
    await buildFirstSteps(page, hand);
    await buildMaze(page, hand);
    assert.deepEqual(troubles, []);
  }));

test('keys alone build the same', () =>
  onPage({ ...TABLET, welcome: true }, async ({ page, troubles }) => {
    const keys = keysOn(page);
    const solved = async () => {
      await keys.press('Control+Enter');
      await says(page, 'task-status', /done/);
    };
    const goOn = async () => {
      await keys.goTo('next-step', 'Shift+Tab');
      await keys.press('Enter');
      await says(page, 'task-status', /^Your task$/);
      await keys.goTo('block-pane');
    };
    await keys.goTo('first-run-learn');
    await keys.press('Enter');
    await keys.goTo('try-step');
    await keys.press('Enter');
    await appears(page, 'run-step');
    await keys.goTo('view-switch');
    await keys.press('Enter');
    await keys.goTo('view-blocks', 'ArrowDown');
    await keys.press('Enter');
    await keys.goTo('block-pane');

    await keys.press('ArrowDown');
    await keys.setNumber(2, 30);
    await keys.press('ArrowDown');
    await keys.add('forward');
    await keys.setNumber(2, 25);
    await areBlocks(page, ['forward 30', 'turn left 90', 'forward 25']);
    await solved();
    await goOn();

    await keys.press('End');
    await keys.add('forward');
    await keys.setNumber(2, 10);
    await keys.add('pen');
    await keys.add('forward');
    await keys.add('pen');
    await keys.press('ArrowRight');
    await keys.choose(/^up$/);
    await areBlocks(page, ['pen down', 'forward 20', 'pen up', 'forward 10', 'pen down', 'forward 20', 'pen up']);
    await solved();
    assert.deepEqual(troubles, []);
  }));
