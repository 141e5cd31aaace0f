// A program goes from the page into a real robot: through a fake tower into a simulated RCX.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { plugIn } from '../brick.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { brick, ends, IN_ROBOT, isImage } from '../send.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { choose, disappears, pointAtTool, press, says, tap } from '../words.mjs';

const WORLD = {
  format: 'robotran-world',
  version: 2,
  title: 'The yard',
  task: 'Drive to the flag.\nBeep there.',
  paper: { width: 80, height: 60 },
  robots: [{ start: { x: 20, y: 15, heading: 0 } }],
  goals: [{ kind: 'reach', region: { circle: { x: 60, y: 50, radius: 6 } } }],
};
const LINK = linkTo('w', WORLD);

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
