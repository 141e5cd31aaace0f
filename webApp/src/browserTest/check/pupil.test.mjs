// Acts like a pupil in the built page: writes Java, uses keys alone, and saves work as files.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { keysOn } from '../blocks.mjs';
import { isKept } from '../kept.mjs';
import { photograph, report } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { appears, choose, chooseFile, press, reports, says, writeProgram } from '../words.mjs';

test('a Java program is written, compiled in the page and run', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await press(page, 'program');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(
      'import josx.platform.rcx.Motor;\n\npublic class Program {\n    public static void main(String[] args) throws InterruptedException {\n' +
        '        Motor.A.forward();\n        Motor.C.forward();\n        Thread.sleep(1000);\n        Motor.A.stop();\n        Motor.C.stop();\n    }\n}\n',
    );
    const { x } = (await report(page)).pose;
    assert.ok(x < 45);
    await press(page, 'run');
    await reports(page, (report) => report.status === 'ended' && report.pose.x > 45);
    await photograph(page, 'java-ran');
    assert.deepEqual(troubles, []);
  }));

test('all is done by keys alone', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const { goTo } = keysOn(page);
    await goTo('run');
    await photograph(page, 'keys-run-focused');
    await page.keyboard.press('Enter');
    await reports(page, (report) => report.inkCentimetres > 5);
    await goTo('stop');
    await page.keyboard.press(' ');
    await reports(page, (report) => report.status === 'ended');
    assert.deepEqual(troubles, []);
  }));

test('where nothing can be kept, that is said before anything is lost', () =>
  onPage({ ...TABLET, prepare: fill }, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 9');
    await appears(page, 'trouble-save-as');
    await appears(page, 'trouble-my-work');
    await photograph(page, 'storage-full');
    const download = page.waitForEvent('download');
    await press(page, 'trouble-save-as');
    assert.match((await download).suggestedFilename(), /\.robotran$/);
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: simulates full browser storage. */
function fill() {
  IDBObjectStore.prototype.put = () => {
    throw new DOMException('There is no room.', 'QuotaExceededError');
  };
}

test('a work is saved as a file and opened from it', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 7\nbeep');
    await isKept(page, 'forward 7');
    const download = page.waitForEvent('download');
    await chooseFile(page, 'work-save-as');
    const file = await (await download).path();
    await choose(page, 'work-menu', 'work-new');
    await says(page, 'program', /^(?!.*forward 7)/);
    const chooser = page.waitForEvent('filechooser');
    await chooseFile(page, 'work-open');
    await (
      await chooser
    ).setFiles([{ name: 'mine.robotran', mimeType: 'application/json', buffer: await readFile(file) }]);
    await says(page, 'program', /forward 7/);
    assert.deepEqual(troubles, []);
  }));
