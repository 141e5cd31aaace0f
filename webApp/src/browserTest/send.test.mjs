// A program goes from the page into a real robot: through a fake tower into a simulated RCX.
import assert from 'node:assert/strict';
import { deflateRawSync } from 'node:zlib';
import { plugIn } from './brick.mjs';
import { photograph } from './page.mjs';
import { onPage, PHONE, TABLET } from './set-up.mjs';
import { test } from './tried-again.mjs';
import { appears, choose, disappears, pointAtTool, press, says, tap, words, writeProgram } from './words.mjs';

const LAPTOP = { width: 1440, height: 900 };
const PHONE_ACROSS = { width: 891, height: 411 };

const WORLD = {
  format: 'robotran-world',
  version: 2,
  title: 'The yard',
  task: 'Drive to the flag.\nBeep there.',
  paper: { width: 80, height: 60 },
  robots: [{ start: { x: 20, y: 15, heading: 0 } }],
  goals: [{ kind: 'reach', region: { circle: { x: 60, y: 50, radius: 6 } } }],
};
const LINK = `#w=a${deflateRawSync(JSON.stringify(WORLD)).toString('base64url')}`;

const JAVA = `import josx.platform.rcx.*;

public class Program {
    public static void main(String[] args) throws InterruptedException {
        Sound.beep();
        Motor.A.forward();
        Thread.sleep(500);
        Motor.A.stop();
    }
}
`;

const brick = (page) =>
  page.evaluate(() => {
    const { firmware, program, firmwareBytes, blocks, device } = globalThis.brick;
    return { firmware, program, firmwareBytes, blocks, asked: device.asked };
  });

const isImage = (bytes) => bytes !== null && bytes[0] === 0xca && bytes[1] === 0xf6 && bytes.length > 1000;

/** Waits longer than other tests: a transfer takes its time. */
const ends = (page, pattern, timeout = 60_000) =>
  page.waitForFunction(
    (source) => new RegExp(source).test(document.querySelector('#robotran-words [data-tag="send-step"]')?.textContent),
    pattern.source,
    { timeout },
  );

const IN_ROBOT = /in the robot\. Press Run/;

test('a program in Robolang goes from a phone into the robot, and the robot answers', () =>
  onPage({ ...PHONE, hasTouch: true, address: LINK, prepare: plugIn({ kind: 'serial' }) }, async ({ page, troubles }) => {
    await says(page, 'task-title', /The yard/);
    await tap(page, 'tab-program');
    await choose(page, 'view-switch', 'view-text');
    await tap(page, 'program');
    await page.keyboard.insertText('forward 20\nbeep\n');
    await photograph(page, 'send-phone-program');
    await pointAtTool(page, 'send-robot', tap);
    await says(page, 'send-step', /Plug in the infrared tower/);
    await photograph(page, 'send-phone-choose');
    await tap(page, 'send-look-serial');
    await ends(page, IN_ROBOT);
    await photograph(page, 'send-phone-done');
    assert.ok(isImage((await brick(page)).program));
    await tap(page, 'send-watch');
    await says(page, 'send-step', /appears here/);
    await page.evaluate(() => globalThis.brick.say([0xf7, 5]));
    await says(page, 'send-message', /message 5/);
    await photograph(page, 'send-phone-messages');
    await tap(page, 'send-cancel');
    await disappears(page, 'send-sheet');
    // The browser remembers the tower, so nothing is asked again.
    await pointAtTool(page, 'send-robot', tap);
    await ends(page, IN_ROBOT);
    assert.deepEqual(troubles, []);
  }));

test('a program in Java goes from a tablet into the robot through the USB tower', () =>
  onPage({ ...TABLET, hasTouch: true, address: LINK, prepare: plugIn({ kind: 'usb' }) }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await press(page, 'program');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(JAVA);
    await pointAtTool(page, 'send-robot', tap);
    await says(page, 'send-step', /Plug in the infrared tower/);
    await photograph(page, 'send-tablet-choose');
    await tap(page, 'send-look-usb');
    await ends(page, IN_ROBOT);
    await photograph(page, 'send-tablet-done');
    const { program, asked } = await brick(page);
    assert.ok(isImage(program));
    assert.deepEqual(asked, [0xfd, 0x04, 0x03], 'version, reset, flush');
    assert.deepEqual(troubles, []);
  }));

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
    { ...LAPTOP, prepare: plugIn({ kind: 'serial', answerAfter: 150, remembered: true }) },
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

// All of a program at 5 % takes minutes of real time: SimulatedBrickTest of shared/workshop does it with a virtual clock.
test('with 5 % of all bytes lost the tower is to be put closer, and then the program arrives whole', () =>
  onPage(
    { ...TABLET, prepare: plugIn({ kind: 'serial', loss: 0.05, remembered: true }) },
    async ({ page, troubles }) => {
      await pointAtTool(page, 'send-robot', press);
      await page.waitForSelector('#robotran-words [data-tag="send-weak"]', { state: 'attached', timeout: 90_000 });
      await photograph(page, 'send-tablet-weak');
      assert.equal((await brick(page)).program, null);
      await page.evaluate(() => {
        globalThis.brick.loss = 0;
      });
      await ends(page, IN_ROBOT, 120_000);
      const { program } = await brick(page);
      await press(page, 'send-cancel');
      await pointAtTool(page, 'send-robot', press);
      await ends(page, IN_ROBOT);
      assert.deepEqual(program, (await brick(page)).program);
      assert.deepEqual(troubles, []);
    },
  ));

test('damaged bytes end the stream of a serial port, and the next one is taken', () =>
  onPage(
    { ...TABLET, prepare: plugIn({ kind: 'serial', loss: 0.0005, damage: true, remembered: true }) },
    async ({ page, troubles }) => {
      await pointAtTool(page, 'send-robot', press);
      await ends(page, IN_ROBOT, 120_000);
      assert.ok((await page.evaluate(() => globalThis.brick.damages)) > 0);
      assert.ok(isImage((await brick(page)).program));
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
