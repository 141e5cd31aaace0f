// A program goes from the page into a hub with Pybricks: through fakes of Web Bluetooth, Web Serial and WebUSB.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { switchOn } from '../hub.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { ends } from '../send.mjs';
import { appears, choose, disappears, pointAtTool, reports, says, tap } from '../words.mjs';

const WORLD = {
  format: 'robotran-world',
  version: 2,
  title: 'The yard',
  task: 'Drive to the flag.\nBeep there.',
  paper: { width: 80, height: 60 },
  robots: [{ start: { x: 20, y: 15, heading: 0 }, robot: 'spike-penbot' }],
  goals: [{ kind: 'reach', region: { circle: { x: 60, y: 50, radius: 6 } } }],
};
const LINK = linkTo('w', WORLD);

/** Takes several pieces on its way. */
const LONG = 'forward 10\nturn right 90\nbeep\n'.repeat(20);

/** A module of MicroPython's bytecode in a container: its size, a name, and the module's first two bytes. */
function assertHolds(slot, source) {
  const bytes = Buffer.from(slot);
  const name = bytes.indexOf(0, 4);
  assert.equal(bytes.readUInt32LE(0), bytes.length - name - 1, 'one module');
  assert.equal(bytes.subarray(4, name).toString(), '__main__');
  assert.deepEqual([...bytes.subarray(name + 1, name + 3)], [0x4d, 6]);
  for (const word of source) assert.ok(bytes.includes(word), `${word} is in the program`);
}

const hub = (page) =>
  page.evaluate(() => {
    const { slot, starts } = globalThis.hub;
    return { slot, starts };
  });

async function writeProgram(page, text) {
  await says(page, 'task-title', /The yard/);
  if (await page.locator('#robotran-words [data-tag="tab-program"]').count()) await tap(page, 'tab-program');
  await choose(page, 'view-switch', 'view-text');
  await tap(page, 'program');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

test('a program goes by Bluetooth from a phone into the hub; the connection breaks in the middle, and the second try is whole', () =>
  onPage(
    { ...PHONE, hasTouch: true, address: LINK, locale: 'de-DE', prepare: switchOn({ way: 'bluetooth', loseAfter: 400, prints: ['42'] }) },
    async ({ page, troubles }) => {
      await writeProgram(page, `${LONG}show 42\n`);
      await pointAtTool(page, 'send-robot', tap);
      await appears(page, 'send-look-bluetooth');
      await photograph(page, 'hub-phone-choose');
      await tap(page, 'send-look-bluetooth');
      await says(page, 'send-step', /Robo 7/);
      await photograph(page, 'hub-phone-found');
      await tap(page, 'send-confirm');
      await appears(page, 'send-again');
      await photograph(page, 'hub-phone-lost');
      assert.equal((await hub(page)).slot, null, 'no part of a program stays');
      await page.evaluate(() => {
        globalThis.hub.isLost = false;
      });
      await tap(page, 'send-again');
      await appears(page, 'send-start');
      await photograph(page, 'hub-phone-ready');
      const { slot, starts } = await hub(page);
      assertHolds(slot, ['straight', 'turn', 'beep']);
      assert.equal(starts, 0, 'nothing drives before the pupil says so');
      await tap(page, 'send-start');
      await says(page, 'send-output', /42/);
      await photograph(page, 'hub-phone-ended');
      await tap(page, 'send-cancel');
      await disappears(page, 'send-sheet');
      assert.deepEqual(troubles, []);
    },
  ));

test('from "which robot" to the hub, by touch, in Spanish, with the program of the first minute', () =>
  onPage(
    { ...PHONE, hasTouch: true, welcome: true, locale: 'es-ES', prepare: switchOn({ way: 'bluetooth', prints: ['hecho'] }) },
    async ({ page, troubles }) => {
      await tap(page, 'try-robot');
      await appears(page, 'robot-spike-prime');
      await photograph(page, 'hub-which-robot');
      await tap(page, 'robot-spike-prime');
      await tap(page, 'run');
      await reports(page, (now) => now.status === 'ended' && now.inkCentimetres > 70);
      await photograph(page, 'hub-drawn');
      await tap(page, 'tab-program');
      await pointAtTool(page, 'send-robot', tap);
      await tap(page, 'send-look-bluetooth');
      await tap(page, 'send-confirm');
      await appears(page, 'send-start');
      assertHolds((await hub(page)).slot, ['straight', 'turn']);
      await tap(page, 'send-start');
      await says(page, 'send-output', /hecho/);
      await photograph(page, 'hub-done-es');
      assert.deepEqual(troubles, []);
    },
  ));

test('a program that runs on is stopped from a tablet, over the serial port of firmware 4.1', () =>
  onPage(
    { ...TABLET, hasTouch: true, address: LINK, prepare: switchOn({ way: 'serial', stays: true, prints: ['on my way'] }) },
    async ({ page, troubles }) => {
      await writeProgram(page, 'repeat forever\n  forward 10\nend\n');
      await pointAtTool(page, 'send-robot', tap);
      await tap(page, 'send-look-usb_serial');
      await says(page, 'send-step', /Robo 7/);
      await tap(page, 'send-confirm');
      await tap(page, 'send-start');
      await says(page, 'send-output', /on my way/);
      await photograph(page, 'hub-tablet-running');
      await tap(page, 'send-stop');
      await page.waitForFunction(() => globalThis.hub.stops > 0);
      await appears(page, 'send-start');
      assertHolds((await hub(page)).slot, ['straight']);
      assert.deepEqual(troubles, []);
    },
  ));

test('the packets of firmware 4.0 take a program, too', () =>
  onPage({ ...TABLET, hasTouch: true, address: LINK, prepare: switchOn({ way: 'packets' }) }, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 10\n');
    await pointAtTool(page, 'send-robot', tap);
    await tap(page, 'send-look-usb_packets');
    await tap(page, 'send-confirm');
    await appears(page, 'send-start');
    assertHolds((await hub(page)).slot, ['straight']);
    assert.deepEqual(troubles, []);
  }));

test("a hub with LEGO's own firmware is told as such", () =>
  onPage({ ...TABLET, hasTouch: true, address: LINK, prepare: switchOn({ way: 'bluetooth', lego: true }) }, async ({ page }) => {
    await writeProgram(page, 'forward 10\n');
    await pointAtTool(page, 'send-robot', tap);
    await tap(page, 'send-look-bluetooth');
    await ends(page, /LEGO/);
    await photograph(page, 'hub-tablet-lego');
  }));

test('whoever cancels is not stuck, and a compiler that does not come is told', () =>
  onPage({ ...TABLET, hasTouch: true, address: LINK, prepare: switchOn({ way: 'bluetooth', pieceTakes: 600, messageBytes: 40 }) }, async ({ page }) => {
    await page.route('**/mpy-cross-v6*.wasm', (route) => route.abort());
    await writeProgram(page, LONG);
    await pointAtTool(page, 'send-robot', tap);
    await appears(page, 'send-again');
    await page.unroute('**/mpy-cross-v6*.wasm');
    await tap(page, 'send-again');
    await tap(page, 'send-look-bluetooth');
    await tap(page, 'send-confirm');
    await page.waitForFunction(() => globalThis.hub.pieces > 0);
    await tap(page, 'send-cancel');
    await appears(page, 'send-again');
    assert.equal((await hub(page)).slot, null);
  }));
