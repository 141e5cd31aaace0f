// Another language chosen in Settings while a run is watched, and what the chart and the brick say of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photograph } from './page.mjs';
import { onPage, PHONE, TABLET } from './set-up.mjs';
import { appears, choose, disappears, press, reports, says, writeProgram } from './words.mjs';

const JAVA = `import josx.platform.rcx.*;
public class Drive {
public static void main(String[] args) throws Exception {
Motor.A.setPower(3);
Motor.A.forward();
Thread.sleep(1000);
Motor.A.stop();
}
}`;

/** Waits until somewhere on the screen is what matches. */
const shows = (page, pattern) => page.waitForFunction(
  (source) => new RegExp(source, 's').test(document.querySelector('#robotran-words').textContent), pattern.source, { timeout: 30_000 });
const shown = (page) => page.evaluate(() => document.querySelector('#robotran-words').textContent);

/** Chooses the language at `place` in Settings. */
async function speak(page, place) {
  await choose(page, 'menu', 'menu-settings');
  await press(page, `language-${place}`);
  await page.keyboard.press('Escape');
  await disappears(page, 'language-0');
}

for (const [what, write] of [
  ['Robolang', (page) => writeProgram(page, 'motor A forward\nwait 1 second\nmotor A stop')],
  ['Java', async (page) => {
    await choose(page, 'add-program', 'new-java');
    await writeProgram(page, JAVA);
  }],
]) {
  test(`the ROM log of a run in ${what} is told in the language that is chosen, and the chart and the brick show one power`, () =>
    onPage(TABLET, async ({ page, troubles }) => {
      await write(page);
      await press(page, 'run');
      await press(page, 'drawer-open');
      await press(page, 'drawer-chart');
      await appears(page, 'value-motor_a');
      // The brick's port and the chart, as long as the motor turns.
      await reports(page, (report) => report.status === 'ended');
      await press(page, 'drawer-log');
      await shows(page, /motor A forward/);
      await speak(page, 3);
      await shows(page, /Motor A vorwärts/);
      assert.doesNotMatch(await shown(page), /motor A forward/);
      await photograph(page, `language-log-${what}`);
      await speak(page, 2);
      await shows(page, /motor A adelante|Motor A adelante/);
      assert.doesNotMatch(await shown(page), /vorwärts/);
      assert.deepEqual(troubles, []);
    }));
}

test('a phone tells the log in another language, too, by touch', () => onPage({ ...PHONE, hasTouch: true }, async ({ page, troubles }) => {
  await press(page, 'run');
  await reports(page, (report) => report.inkCentimetres > 5);
  await speak(page, 3);
  await says(page, 'run', /Starten/);
  assert.deepEqual(troubles, []);
}));
