// Builds programs from blocks in the page: with a finger, with a screen reader, and with keys.
import assert from 'node:assert/strict';
import { areBlocks, fingerOn, keysOn, readerOn } from '../blocks.mjs';
import { journeyOf } from '../journey.mjs';
import { isKept } from '../kept.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, choose, disappears, press, says, words, writeProgram } from '../words.mjs';

/**
 * A journey has hundreds of steps, and each waits for frames. Below a lesson there is room for all blocks of its program: what is out of sight is
 * not told.
 */
const QUICK = { ...TABLET, height: 1240, welcome: true, pause: 20 };

test('a finger builds the solutions of the first five steps of the tutorial', () =>
  onPage({ ...QUICK, hasTouch: true }, async ({ page, troubles }) => {
    const journey = journeyOf(page, fingerOn(page));
    await journey.buildFirstSteps();
    await journey.buildMaze();
    assert.deepEqual(troubles, []);
  }));

test('a screen reader builds the same', () =>
  onPage(QUICK, async ({ page, troubles }) => {
    const journey = journeyOf(page, readerOn(page));
    await journey.buildFirstSteps();
    await journey.buildMaze();
    assert.deepEqual(troubles, []);
  }));

test('keys alone build the same', () =>
  onPage(QUICK, async ({ page, troubles }) => {
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
    await keys.goTo('first-blocks');
    await keys.press('Enter');
    await keys.goTo('try-tutorial');
    await keys.press('Enter');
    await appears(page, 'hint-wanted');
    await keys.goTo('run-more');
    await keys.press('Enter');
    await keys.goTo('panel-speed-fastest');
    await keys.press('Enter', 'Escape');
    await disappears(page, 'run-panel-close');
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
    await goOn();

    await keys.press('ArrowDown', 'ArrowDown');
    await keys.setNumber(1, 6);
    await keys.press('ArrowDown', 'ArrowDown');
    await keys.setNumber(2, 60);
    await solved();
    await goOn();

    await keys.press('End', 'ArrowUp', 'ArrowUp');
    await keys.setNumber(5, 5);
    await solved();
    await goOn();

    await keys.press('ArrowDown');
    await keys.open('F2');
    await keys.goTo('actions-more', 'Tab');
    await keys.press('Enter');
    await keys.goTo('form-0', 'Tab');
    await keys.press('Enter');
    await keys.isBack();
    await keys.setNumber(2, 5);
    await keys.setNumber(1, 1);
    await keys.setNumber(1, -1);
    await keys.press('End');
    await keys.add('forward');
    await keys.setNumber(2, 45);
    await solved();

    await keys.goTo('step-more', 'Shift+Tab');
    await keys.press('Enter');
    await keys.goTo('leave-tutorial', 'ArrowDown');
    await keys.press('Enter');
    await keys.goTo('worlds', 'Shift+Tab');
    await keys.press('Enter');
    await keys.goTo('world-search');
    await page.keyboard.type('maze');
    await keys.goTo('world-maze');
    await keys.press('Enter');
    await says(page, 'task-title', /The maze/);
    await keys.goTo('add-program');
    await keys.press('Enter');
    await keys.goTo('new-robolang', 'ArrowDown');
    await keys.press('Enter');
    await keys.goTo('block-pane');
    await keys.add('power left');
    await keys.add('power left');
    await keys.press('ArrowRight');
    await keys.choose(/^right$/);
    await keys.setNumber(1, 1);
    await keys.add('forever');
    await keys.add('start forward');
    await keys.add('wait until');
    await keys.press('ArrowRight');
    await keys.choose(/^left bumper and right bumper$/);
    await keys.press('ArrowUp', 'ArrowDown');
    await keys.goToPart(/^and,/);
    await keys.choose(/^or$/);
    await keys.add('else');
    for (const [distance, angle] of [
      [4, 90],
      [2, 25],
    ]) {
      await keys.add('forward');
      await keys.press('ArrowRight');
      await keys.choose(/^backward$/);
      await keys.setNumber(1, distance);
      await keys.add('turn');
      if (angle !== 90) await keys.setNumber(2, angle);
      await keys.press('ArrowDown');
    }
    await photograph(page, 'blocks-keys-maze');
    await isKept(page, 'wait until left bumper or right bumper');
    await keys.press('Control+Enter');
    await says(page, 'goal-chip', /All goals met/);
    assert.deepEqual(troubles, []);
  }));

test('a program is seen in blocks, as text and as both, and after a reload as it was last', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 15\nbeep');
    await choose(page, 'view-switch', 'view-blocks');
    await disappears(page, 'program');
    await areBlocks(page, ['forward 15', 'beep']);
    await choose(page, 'view-switch', 'view-both');
    await press(page, 'program');
    await page.waitForTimeout(500);
    await press(page, 'program');
    await page.keyboard.press('Control+End');
    await page.keyboard.press('Enter');
    await page.keyboard.type('buzz');
    await areBlocks(page, ['forward 15', 'beep', 'buzz']);
    await photograph(page, 'blocks-and-text');
    await isKept(page, 'buzz');
    await isKept(page, '"both"');
    await reload(page);
    await appears(page, 'program');
    await areBlocks(page, ['forward 15', 'beep', 'buzz']);
    await choose(page, 'add-program', 'new-java');
    await disappears(page, 'block-pane');
    assert.equal(await words(page, 'view-switch').count(), 0, 'Java has no blocks');
    assert.deepEqual(troubles, []);
  }));
