// A pupil's way through NQC and LEGO's own firmware: a program of its own, a mistake, the debugger, the assembly, an image from a
// file.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { isKept } from '../kept.mjs';
import { assertRecordedRun, photograph, reload } from '../page.mjs';
import { browserOptions, onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import {
  choose,
  chooseFile,
  disappears,
  enterProgram,
  isSaid,
  press,
  programText,
  reports,
  says,
  tap,
  tapFor,
} from '../words.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

const COUNTING = `int rounds = 0;

task main()
{
    start music;
    repeat (3)
    {
        OnFwd(OUT_A + OUT_C);
        Wait(100);
        rounds = rounds + 1;
    }
    Off(OUT_A + OUT_C);
    stop music;
}

task music()
{
    while (true)
    {
        PlayTone(440, 10);
        Wait(50);
    }
}
`;

/** The line, from 1, of COUNTING with `text`. */
const lineWith = (text) => COUNTING.split('\n').findIndex((line) => line.includes(text)) + 1;

/** Replaces the current program by `text`, as pasted. */
async function replace(page, text) {
  await enterProgram(page);
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

/** Moves the caret to `line` of the current program. */
async function goToLine(page, line) {
  await page.keyboard.press('Control+Home');
  for (let step = 1; step < line; step++) await page.keyboard.press('ArrowDown');
}

/** Opens `files` by the menu. */
async function openFiles(page, files) {
  const chooser = page.waitForEvent('filechooser');
  await chooseFile(page, 'work-open');
  await (await chooser).setFiles(files);
}

/** What the item `item` of the menu saves. */
async function saved(page, item) {
  const download = page.waitForEvent('download');
  await chooseFile(page, item);
  const file = await download;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

test('every example in NQC makes its recorded run in the browser, bit for bit', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const examples = process.env.EXAMPLES.split(path.delimiter).filter((file) => file.endsWith('.nqc'));
    assert.ok(examples.length >= 10, `${examples.length} examples`);
    for (const example of examples) await assertRecordedRun(page, example, process.env.EXPECTED_NQC_RUNS);
    assert.deepEqual(troubles, []);
  }));

test('a tablet writes NQC, mends a mistake, stops at a line and sees tasks and variables', () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-nqc');
    await says(page, 'program', /task main/);
    await replace(page, COUNTING.replace('rounds = rounds', 'round = rounds'));
    await isSaid(page, new RegExp(`Line ${lineWith('rounds + 1')}: `));
    await photograph(page, 'nqc-mistake');
    await press(page, 'fix');
    await disappears(page, 'fix');
    assert.equal((await programText(page)).trimEnd(), COUNTING.trimEnd());
    await enterProgram(page);
    await goToLine(page, lineWith('rounds + 1'));
    await page.keyboard.press('F9');
    await press(page, 'run');
    await says(page, 'status', new RegExp(`Paused at line ${lineWith('rounds + 1')}`));
    await tapFor(page, 'drawer-variables', 'variable-rounds');
    await says(page, 'variable-rounds', /0/);
    await says(page, 'thread-1', /music/);
    await photograph(page, 'nqc-variables');
    await press(page, 'pause');
    await says(page, 'variable-rounds', /1/);
    await press(page, 'stop');
    await reports(page, (report) => report.status === 'ended');
    assert.deepEqual(troubles, []);
  }));

test('the assembly is beside it, becomes an image, and the image comes back from its file', () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-nqc');
    await replace(page, COUNTING);
    await tapFor(page, 'translation-switch', 'translation-text');
    await says(page, 'translation-text', /wait\s+2, 100/);
    await photograph(page, 'nqc-assembly');
    const source = await saved(page, 'work-program-file');
    assert.equal(source.name, 'program.nqc');
    const image = await saved(page, 'work-kit');
    assert.equal(image.name, 'program.rcx');
    assert.equal(image.bytes.subarray(0, 4).toString('latin1'), 'RCXI');
    await openFiles(page, [{ name: 'robot.rcx', mimeType: 'application/octet-stream', buffer: image.bytes }]);
    await says(page, 'program', /task\s+0/);
    await press(page, 'run');
    await reports(page, (report) => report.status === 'running');
    await isKept(page, 'robot.lasm');
    await reload(page);
    await tap(page, 'program-2');
    await says(page, 'program', /wait\s+2, 100/);
    const again = await saved(page, 'work-kit');
    assert.deepEqual(again.bytes, image.bytes);
    assert.deepEqual(troubles, []);
  }));

test('a phone opens an example in NQC in German and runs it', () =>
  onPage({ ...PHONE, hasTouch: true, isMobile: true, locale: 'de-DE' }, async ({ page, troubles }) => {
    await tap(page, 'tab-program');
    await choose(page, 'add-program', 'new-nqc');
    await says(page, 'program', /task main/);
    await photograph(page, 'nqc-phone-program');
    await choose(page, 'add-program', 'examples');
    await tapFor(page, 'example-countdown.nqc', 'program');
    await says(page, 'program', /SetUserDisplay/);
    await tap(page, 'run');
    await reports(page, (report) => report.status === 'running');
    await tap(page, 'tab-brick');
    await photograph(page, 'nqc-phone-brick');
    assert.deepEqual(troubles, []);
  }));
