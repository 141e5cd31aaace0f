// A program gets from the page onto a micro:bit: as a file, and through a fake of WebUSB.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { linkTo } from '../link.mjs';
import { MICROPYTHON, MICROPYTHON_FOR_BOTH, mainIn, plugIn } from '../microbit.mjs';
import { photograph } from '../page.mjs';
import { ends } from '../send.mjs';
import { onPage, PHONE } from '../set-up.mjs';
import { appears, choose, disappears, isSaid, pointAtTool, press, reports, says, tap } from '../words.mjs';

const LAPTOP = { width: 1366, height: 768 };

const worldOf = (robot) => ({
  format: 'robotran-world',
  version: 2,
  title: 'The yard',
  task: 'Drive to the flag.\nBeep there.',
  paper: { width: 80, height: 60 },
  robots: [{ start: { x: 20, y: 15, heading: 0 }, robot }],
  goals: [{ kind: 'reach', region: { circle: { x: 60, y: 50, radius: 6 } } }],
});
const LINK = linkTo('w', worldOf('cutebot'));
const LINK_V1 = linkTo('w', worldOf('cutebot-v1'));

/** Runs in the page: takes WebUSB away, as in Firefox and Safari. */
function withoutUsb() {
  for (const name of ['serial', 'usb', 'bluetooth']) Object.defineProperty(navigator, name, { value: undefined });
}

async function writeProgram(page, text) {
  await says(page, 'task-title', /The yard/);
  await choose(page, 'view-switch', 'view-text');
  await press(page, 'program');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

/** Opens `file` in the sheet, by `point`. */
async function open(page, file, point = press) {
  const chooser = page.waitForEvent('filechooser');
  await point(page, 'send-choose-micropython');
  await (await chooser).setFiles([file]);
}

/** The text of the file that `act` saves, and its name. */
async function saved(page, act) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), 'utf8') };
}

const board = (page) =>
  page.evaluate(() => {
    const { hex, main, starts, questions } = globalThis.board;
    return { hex, main, starts, questions };
  });

/** Waits until the program is on the board and it has printed `pattern`. */
async function assertRuns(page, pattern) {
  await says(page, 'send-output', pattern);
  assert.match(await page.locator('#robotran-words [data-tag="send-step"]').textContent(), /press A|has ended/);
}

test('from "which robot" to a saved file, by touch, in Spanish, with the program of the first minute', () =>
  onPage({ ...PHONE, hasTouch: true, welcome: true, locale: 'es-ES', prepare: withoutUsb }, async ({ page, troubles }) => {
    await tap(page, 'try-robot');
    await appears(page, 'robot-microbit');
    await photograph(page, 'microbit-which-robot');
    await tap(page, 'robot-microbit');
    await appears(page, 'buggy-maqueen');
    await photograph(page, 'microbit-which-buggy');
    await tap(page, 'buggy-cutebot');
    await tap(page, 'run');
    await reports(page, (now) => now.status === 'ended' && now.inkCentimetres > 70);
    await photograph(page, 'microbit-drawn');
    await tap(page, 'tab-program');
    await pointAtTool(page, 'send-robot', tap);
    await ends(page, /Abre primero un archivo con MicroPython/);
    await photograph(page, 'microbit-phone-first');
    await open(page, { name: 'foto.hex', mimeType: 'application/octet-stream', buffer: Buffer.from('no hex') }, tap);
    await ends(page, /foto\.hex: Esto no es un archivo para un micro:bit/);
    await photograph(page, 'microbit-phone-wrong-file');
    await open(page, MICROPYTHON_FOR_BOTH, tap);
    await appears(page, 'send-save-hex');
    await photograph(page, 'microbit-phone-choose');
    const { name, text } = await saved(page, () => tap(page, 'send-save-hex'));
    assert.match(name, /\.hex$/);
    assert.match(mainIn(text), /from microbit import/);
    assert.match(text, /:0400000A9903/, 'it is for both boards');
    await ends(page, /está guardado/);
    await photograph(page, 'microbit-phone-saved');
    await tap(page, 'send-back');
    const python = await saved(page, () => tap(page, 'send-save-python'));
    assert.equal(python.name, 'main.py');
    assert.equal(python.text, mainIn(text));
    assert.deepEqual(troubles, []);
  }));

test('a board without MicroPython gets everything; the second program goes alone, without a question', () =>
  onPage({ ...LAPTOP, address: LINK, prepare: plugIn({ prints: ['on my way'] }) }, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 10\nbeep\n');
    await pointAtTool(page, 'send-robot', press);
    await open(page, MICROPYTHON);
    await appears(page, 'send-save-hex');
    await says(page, 'send-room', /of \d+,\d+ bytes/);
    await photograph(page, 'microbit-laptop-choose');
    await press(page, 'send-usb');
    await appears(page, 'send-confirm');
    await photograph(page, 'microbit-laptop-found');
    await press(page, 'send-confirm');
    await assertRuns(page, /on my way/);
    await photograph(page, 'microbit-laptop-running');
    const first = await board(page);
    assert.match(mainIn(first.hex), /from microbit import/);
    assert.equal(first.main, null);
    await press(page, 'send-cancel');
    await disappears(page, 'send-sheet');
    await writeProgram(page, 'forward 20\nshow "HELLO"\n');
    await pointAtTool(page, 'send-robot', press);
    await press(page, 'send-usb');
    await assertRuns(page, /on my way/);
    const second = await board(page);
    assert.match(second.main, /HELLO/);
    assert.equal(second.hex, first.hex, 'MicroPython stays as it is');
    assert.equal(second.questions, 1);
    assert.deepEqual(troubles, []);
  }));

test('a file that is cancelled, one that breaks off, and one that is whole', () =>
  onPage({ ...LAPTOP, address: LINK, prepare: plugIn({ pieceTakes: 150 }) }, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 10\n'.repeat(30));
    await pointAtTool(page, 'send-robot', press);
    await open(page, MICROPYTHON);
    await press(page, 'send-usb');
    await press(page, 'send-whole');
    await page.waitForFunction(() => globalThis.board.pieces > 2);
    await photograph(page, 'microbit-laptop-sending');
    await press(page, 'send-cancel');
    await ends(page, /Cancelled/);
    await isSaid(page, /may have no whole program/);
    await photograph(page, 'microbit-laptop-cancelled');
    await page.evaluate(() => {
      globalThis.board.loseAfter = 400;
    });
    // A part of a file has no Python that could answer, so all of it is sent.
    await press(page, 'send-again');
    await ends(page, /was unplugged in the middle/);
    await photograph(page, 'microbit-laptop-lost');
    assert.equal((await board(page)).hex, null);
    await page.evaluate(() => {
      globalThis.board.pieceTakes = 0;
      globalThis.board.plugIn();
    });
    await press(page, 'send-again');
    // It is connected anew, so the board is shown before anything is sent.
    await press(page, 'send-confirm');
    await page.waitForFunction(() => globalThis.board.hex !== null);
    await ends(page, /press A/);
    assert.match(mainIn((await board(page)).hex), /from microbit import/);
    assert.deepEqual(troubles, []);
  }));

test('a V1 takes its packets by control transfers, and a program alone where MicroPython is', () =>
  onPage(
    { ...LAPTOP, address: LINK_V1, prepare: plugIn({ v1: true, hasPython: true, isRemembered: true, prints: ['hello'] }) },
    async ({ page, troubles }) => {
      await writeProgram(page, 'forward 10\n');
      await pointAtTool(page, 'send-robot', press);
      await press(page, 'send-usb');
      await press(page, 'send-confirm');
      await assertRuns(page, /hello/);
      const { main, hex, questions } = await board(page);
      assert.match(main, /from microbit import/);
      assert.deepEqual([hex, questions], [null, 0]);
      assert.deepEqual(troubles, []);
    },
  ));

test('an error of the program is told at its line', () => {
  const prints = ['Traceback (most recent call last):', '  File "main.py", line LINE, in <module>', 'ZeroDivisionError: divide by zero'];
  return onPage({ ...LAPTOP, address: LINK, prepare: plugIn({ hasPython: true }) }, async ({ page }) => {
    await writeProgram(page, 'beep\nforward 10\n');
    await pointAtTool(page, 'send-robot', press);
    await press(page, 'send-usb');
    await press(page, 'send-confirm');
    await ends(page, /press A/);
    await page.evaluate((lines) => {
      const { main, print } = globalThis.board;
      // The last line of the Python that comes from the pupil's second line drives.
      const line = main.split('\n').findLastIndex((each) => /drive|forward|ahead/.test(each) && !/def /.test(each)) + 1;
      for (const each of lines) print(each.replace('LINE', line));
    }, prints);
    await ends(page, /ZeroDivisionError/);
    await appears(page, 'send-show-line');
    await photograph(page, 'microbit-laptop-error');
    await press(page, 'send-show-line');
    await disappears(page, 'send-sheet');
  });
});

test('another app that has the board, the wrong MicroPython and a board that refuses are told', () =>
  onPage({ ...LAPTOP, address: LINK, prepare: plugIn({ isTaken: true }) }, async ({ page }) => {
    await writeProgram(page, 'forward 10\n');
    await pointAtTool(page, 'send-robot', press);
    await press(page, 'send-usb');
    await ends(page, /Another app or tab uses the micro:bit/);
    await photograph(page, 'microbit-laptop-taken');
    await press(page, 'send-back');
    await open(page, { ...MICROPYTHON, name: 'cut.hex', buffer: MICROPYTHON.buffer.subarray(0, 300) });
    await ends(page, /cut\.hex: /);
  }));

test('a board that refuses the file says why', () =>
  onPage({ ...LAPTOP, address: LINK, prepare: plugIn({ refuse: 25 }) }, async ({ page }) => {
    await writeProgram(page, 'forward 10\n');
    await pointAtTool(page, 'send-robot', press);
    await open(page, MICROPYTHON);
    await press(page, 'send-usb');
    await press(page, 'send-whole');
    await ends(page, /This file is not for this micro:bit.*error 25/);
    await photograph(page, 'microbit-laptop-refused');
  }));
