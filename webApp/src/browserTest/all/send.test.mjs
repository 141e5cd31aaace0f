// What else can happen on the way into a real robot: mistakes, cancelling, a brick that is off, bytes that are lost, firmware.
import assert from 'node:assert/strict';
import { plugIn } from '../brick.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { brick, ends, IN_ROBOT, isImage } from '../send.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { disappears, pointAtTool, press, says, tap, writeProgram } from '../words.mjs';

const LAPTOP = { width: 1440, height: 900 };
/** A link to a program that takes long enough on its way for somebody to cancel it. */
const LONG = linkTo('p', {
  format: 'robotran-project',
  version: 1,
  world: {
    format: 'robotran-world',
    version: 2,
    title: 'A sheet',
    paper: { width: 100, height: 80 },
    robots: [{ start: { x: 30, y: 30, heading: 0 } }],
  },
  robots: [
    {
      name: 'yellow',
      programs: [{ name: 'long.robo', language: 'robolang', text: Array(400).fill('forward 2') }],
    },
  ],
});
const PHONE_ACROSS = { width: 891, height: 411 };

test('a program with a mistake is not sent, and its mistake is a touch away', () =>
  onPage({ ...TABLET, hasTouch: true, prepare: plugIn({ kind: 'serial' }) }, async ({ page, troubles }) => {
    await writeProgram(page, 'beep\nforwrd 20');
    await pointAtTool(page, 'send-robot', tap);
    await says(page, 'send-step', /cannot take this program yet/);
    await photograph(page, 'send-tablet-mistake');
    await tap(page, 'send-show-mistake');
    await disappears(page, 'send-sheet');
    await says(page, 'fix', /forward/);
    assert.deepEqual(troubles, []);
  }));

test('a transfer can be cancelled, and the robot is left without a program until it is sent again', () =>
  onPage(
    { ...LAPTOP, address: LONG, prepare: plugIn({ kind: 'serial', answerAfter: 150, remembered: true }) },
    async ({ page, troubles }) => {
      await pointAtTool(page, 'send-robot', press);
      await says(page, 'send-block', /Block [2-9] of/);
      await photograph(page, 'send-laptop-sending');
      assert.equal((await brick(page)).program, null);
      await press(page, 'send-cancel');
      await ends(page, /has no program now/);
      await photograph(page, 'send-laptop-cancelled');
      assert.equal((await brick(page)).program, null);
      await press(page, 'send-again');
      await ends(page, IN_ROBOT);
      assert.ok(isImage((await brick(page)).program));
      // Escape closes the sheet.
      await page.keyboard.press('Escape');
      await disappears(page, 'send-sheet');
      assert.deepEqual(troubles, []);
    },
  ));

test('a brick that is off is told, and another try finds it switched on', () =>
  onPage(
    { ...PHONE_ACROSS, hasTouch: true, prepare: plugIn({ kind: 'serial', isOn: false, remembered: true }) },
    async ({ page, troubles }) => {
      await tap(page, 'tab-program');
      await pointAtTool(page, 'send-robot', tap);
      await ends(page, /Your robot does not answer\. Switch it on/);
      await photograph(page, 'send-phone-across-off');
      await page.evaluate(() => {
        globalThis.brick.isOn = true;
      });
      await tap(page, 'send-again');
      await ends(page, IN_ROBOT);
      assert.ok(isImage((await brick(page)).program));
      assert.deepEqual(troubles, []);
    },
  ));

// All of a program at 5 % takes minutes of real time: SimulatedBrickTest of shared/workshop does it with a virtual clock.
test('with 5 % of all bytes lost the tower is to be put closer, and then the program arrives whole', () =>
  onPage(
    { ...TABLET, prepare: plugIn({ kind: 'serial', loss: 0.05, remembered: true }) },
    async ({ page, troubles }) => {
      await pointAtTool(page, 'send-robot', press);
      await page.waitForSelector('#robotran-words [data-tag="send-weak"]', { state: 'attached' });
      await photograph(page, 'send-tablet-weak');
      assert.equal((await brick(page)).program, null);
      await page.evaluate(() => {
        globalThis.brick.loss = 0;
      });
      await ends(page, IN_ROBOT);
      const { program } = await brick(page);
      await press(page, 'send-cancel');
      await pointAtTool(page, 'send-robot', press);
      await ends(page, IN_ROBOT);
      assert.deepEqual(program, (await brick(page)).program);
      assert.deepEqual(troubles, []);
    },
  ));

/** The lines of a firmware file with `text` at 8000. */
function firmwareFile(text) {
  const hex = (byte) => byte.toString(16).toUpperCase().padStart(2, '0');
  const record = (type, address, data) => {
    const counted = [data.length + 3, address >> 8, address & 0xff, ...data];
    const sum = counted.reduce((sum, byte) => sum + byte, 0);
    return `S${type}${[...counted, 255 - (sum % 256)].map(hex).join('')}`;
  };
  const bytes = Array.from(text, (letter) => letter.charCodeAt(0));
  const lines = [record(0, 0, [0x61])];
  for (let at = 0; at < bytes.length; at += 16) lines.push(record(1, 0x8000 + at, bytes.slice(at, at + 16)));
  return [...lines, record(9, 0x8000, [])].join('\n');
}

test('a brick without leJOS gets the firmware file that the pupil chooses, then the program', () =>
  onPage(
    { ...TABLET, hasTouch: true, prepare: plugIn({ kind: 'usb', firmware: 'lego', remembered: true }) },
    async ({ page, troubles }) => {
      await pointAtTool(page, 'send-robot', tap);
      await ends(page, /has LEGO's own firmware .*needs leJOS/);
      await photograph(page, 'send-tablet-firmware');
      const give = async (name, text) => {
        const chooser = page.waitForEvent('filechooser');
        await tap(page, 'send-choose-firmware');
        await (await chooser).setFiles([{ name, mimeType: 'application/octet-stream', buffer: Buffer.from(text) }]);
      };
      await give('holiday.srec', 'not a firmware');
      await ends(page, /holiday\.srec is not a firmware/);
      await give('lejos.srec', firmwareFile(`${'x'.repeat(300)}Do you byte, when I knock?${'y'.repeat(300)}`));
      await ends(page, /lejos\.srec is a firmware for the RCX/);
      await photograph(page, 'send-tablet-firmware-chosen');
      await tap(page, 'send-firmware');
      await ends(page, IN_ROBOT);
      const { firmware, firmwareBytes, program } = await brick(page);
      assert.equal(firmware, 'lejos');
      assert.equal(firmwareBytes.length, 626);
      assert.ok(isImage(program));
      assert.deepEqual(troubles, []);
    },
  ));

test('a browser that reaches no tower says which one does', () =>
  onPage({ ...PHONE, hasTouch: true, prepare: withoutTowers }, async ({ page, troubles }) => {
    await tap(page, 'tab-program');
    await pointAtTool(page, 'send-robot', tap);
    await ends(page, /Open it in Chrome or Edge on a computer/);
    await photograph(page, 'send-phone-no-towers');
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: takes Web Serial and WebUSB away, as in Firefox and Safari. */
function withoutTowers() {
  for (const name of ['serial', 'usb']) Object.defineProperty(navigator, name, { value: undefined });
}

for (const kind of ['serial', 'usb']) {
  test(`a ${kind} tower that is unplugged in the middle is told, and goes on once it is plugged in again`, () =>
    onPage({ ...PHONE, hasTouch: true, prepare: plugIn({ kind, remembered: true, unplugAfterBlocks: 3 }) }, async ({ page, troubles }) => {
      await tap(page, 'tab-program');
      await pointAtTool(page, 'send-robot', tap);
      await ends(page, /The tower was unplugged/);
      await photograph(page, `send-phone-unplugged-${kind}`);
      assert.equal((await brick(page)).program, null);
      await page.evaluate(() => globalThis.brick.plugIn());
      await tap(page, 'send-again');
      await ends(page, IN_ROBOT);
      assert.deepEqual(troubles, []);
    }));
}

test('damaged bytes end the stream of a serial port, and the next one is taken', () =>
  onPage(
    { ...TABLET, prepare: plugIn({ kind: 'serial', loss: 0.0005, damage: true, remembered: true }) },
    async ({ page, troubles }) => {
      await pointAtTool(page, 'send-robot', press);
      await ends(page, IN_ROBOT);
      assert.ok((await page.evaluate(() => globalThis.brick.damages)) > 0);
      assert.ok(isImage((await brick(page)).program));
      assert.deepEqual(troubles, []);
    },
  ));

test('whoever chooses no tower is told, and a tower that a driver holds is told', () =>
  onPage({ ...TABLET, prepare: plugIn({ kind: 'usb' }) }, async ({ page, troubles }) => {
    await page.evaluate(() => {
      globalThis.brick.refuses = true;
    });
    await pointAtTool(page, 'send-robot', press);
    await press(page, 'send-look-usb');
    await ends(page, /No tower was chosen/);
    await page.evaluate(() => Object.assign(globalThis.brick, { refuses: false, heldByDriver: true }));
    await press(page, 'send-look-usb');
    await ends(page, /A driver of this computer holds the tower/);
    await photograph(page, 'send-tablet-held');
    assert.deepEqual(troubles, []);
  }));
