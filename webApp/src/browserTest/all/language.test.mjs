// Changes the language in Settings during a run, and checks the texts of the chart and the brick.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { photograph } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { choose, chooseFile, disappears, PATIENCE, press, reports, says, writeProgram } from '../words.mjs';

const JAVA = `import josx.platform.rcx.*;
public class Program {
public static void main(String[] args) throws Exception {
Motor.A.setPower(3);
Motor.A.forward();
Thread.sleep(20000);
}
}`;

/** Waits until any text on the screen matches. */
const shows = (page, pattern) =>
  page.waitForFunction(
    (source) => new RegExp(source, 's').test(document.querySelector('#robotran-words').innerHTML),
    pattern.source,
    { timeout: PATIENCE },
  );
const shown = (page) => page.evaluate(() => document.querySelector('#robotran-words').innerHTML);

/** Selects the language at index `place` in Settings. */
async function speak(page, place) {
  await choose(page, 'menu', 'menu-settings');
  await press(page, `language-${place}`);
  await press(page, 'settings-close');
  await disappears(page, 'language-0');
}

for (const [what, write] of [
  ['Robolang', (page) => writeProgram(page, 'motor A forward\nwait 20 seconds')],
  [
    'Java',
    async (page) => {
      await choose(page, 'add-program', 'new-java');
      await press(page, 'program');
      await page.keyboard.press('Control+a');
      await page.keyboard.insertText(JAVA);
    },
  ],
]) {
  test(`the ROM log of a run in ${what} is told in the language that is chosen, and the chart and the brick show one power`, () =>
    onPage(TABLET, async ({ page, troubles }) => {
      await write(page);
      await press(page, 'brick-size');
      await press(page, 'run');
      await says(page, 'port-A', /forward, power 3/);
      await press(page, 'drawer-chart');
      await shows(page, /Motor A: \+3/);
      await press(page, 'stop');
      await reports(page, (report) => report.status === 'ended');
      await press(page, 'drawer-log');
      await press(page, 'log-program');
      await shows(page, /motor A forward/);
      await speak(page, 3);
      await shows(page, /Motor A vorwärts/);
      assert.doesNotMatch(await shown(page), /motor A forward/);
      await photograph(page, `language-log-${what}`);
      await speak(page, 2);
      await shows(page, /motor A hacia delante/);
      assert.doesNotMatch(await shown(page), /vorwärts/);
      assert.deepEqual(troubles, []);
    }));
}

test('a phone tells the log in another language, too, by touch', () =>
  onPage({ ...PHONE, hasTouch: true }, async ({ page, troubles }) => {
    await press(page, 'run');
    await reports(page, (report) => report.inkCentimetres > 5);
    await speak(page, 3);
    await says(page, 'run', /Starten/);
    assert.deepEqual(troubles, []);
  }));

test('a program in Java has a kit for a real robot, as one in Robolang has', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const kit = async () => {
      const download = page.waitForEvent('download');
      await chooseFile(page, 'work-kit');
      const file = await download;
      assert.match(file.suggestedFilename(), /\.zip$/);
      return (await readFile(await file.path())).toString('latin1');
    };
    const square = await kit();
    for (const name of [
      'Square/Square.java',
      'Square/square.robo',
      'Square/README.txt',
      'Square/build.xml',
      'Square/download.sh',
    ]) {
      assert.ok(square.includes(name), name);
    }
    await choose(page, 'add-program', 'new-java');
    await writeProgram(page, JAVA);
    const files = await kit();
    for (const part of [
      'Program/Program.java',
      'Program/README.txt',
      'Program/build.xml',
      'Program/download.bat',
      '$compiler -encoding UTF-8 Program.java',
    ]) {
      assert.ok(files.includes(part), part);
    }
    assert.deepEqual(troubles, []);
  }));
