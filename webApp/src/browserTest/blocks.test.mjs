// Builds programs from blocks in the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { areBlocks, keysOn } from './blocks.mjs';
import { isKept } from './kept.mjs';
import { photograph } from './page.mjs';
import { onPage, TABLET } from './set-up.mjs';
import { appears, disappears, press, says } from './words.mjs';

test('keys alone build the solutions of the first five steps of the tutorial, and of the maze', () =>
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
    await keys.goTo('first-blocks');
    await keys.press('Enter');
    await keys.goTo('try-tutorial');
    await keys.press('Enter');
    await appears(page, 'run-step');
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

    await keys.press('ArrowDown', 'F2');
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

    await keys.goTo('leave-tutorial', 'Shift+Tab');
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
    await keys.goToPart(/^left,/);
    await keys.choose(/^right$/);
    await keys.add('else', 'take-else');
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

const PROJECT = {
  format: 'robotran-project',
  version: 1,
  world: { format: 'robotran-world', version: 2, title: 'A sheet', paper: { width: 80, height: 60 }, robots: [{ start: { x: 20, y: 15, heading: 0 } }] },
  robots: [
    {
      name: 'yellow',
      programs: [{ name: 'edge.robo', language: 'robolang', text: ['repeat 2 times', '  forwrd 3', 'end'], view: 'blocks' }],
    },
  ],
};

test('a link opens its program in blocks, and a mistake is a loose line with a fix', () =>
  onPage(
    { ...TABLET, address: `#p=a${deflateRawSync(JSON.stringify(PROJECT)).toString('base64url')}` },
    async ({ page, troubles }) => {
      await areBlocks(page, ['repeat 2 times', 'line with a mistake: forwrd 3', 'End of']);
      await photograph(page, 'blocks-mistake');
      await press(page, 'fix');
      await areBlocks(page, ['repeat 2 times', 'forward 3', 'End of']);
      assert.deepEqual(troubles, []);
    },
  ));
