// A class of hand-ins in the page.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { onPage, TABLET } from './set-up.mjs';
import { appears, asTeacher, choose, chooseFile, press, says } from './words.mjs';

const grades = process.env.EXPECTED_GRADES;

// Classes of hand-ins, good, bad and hostile ones, with the grades that the JVM gives them.
export const RCX = { folder: grades, assignment: 'parking.robotran', title: /Parking/ };
export const NXT = { folder: path.join(grades, 'nxt'), assignment: 'wall.robotran', title: /Before the wall/ };

const file = async (name) => ({
  name: path.basename(name),
  mimeType: 'application/octet-stream',
  buffer: await readFile(name),
});

/** Opens the assignment and lets the page grade the class. */
export async function grade(page, { folder, assignment, title } = RCX) {
  let chooser = page.waitForEvent('filechooser');
  await chooseFile(page, 'work-open');
  await (await chooser).setFiles([await file(path.join(folder, assignment))]);
  await says(page, 'task-title', title);
  await asTeacher(page, 'teachers-hand-ins');
  chooser = page.waitForEvent('filechooser');
  await press(page, 'hand-ins-choose');
  const names = (await readdir(path.join(folder, 'class'))).sort();
  await (await chooser).setFiles(await Promise.all(names.map((name) => file(path.join(folder, 'class', name)))));
  // Until then, hand-ins that cannot be used may be there alone.
  await appears(page, 'hand-ins-cancel');
}

/** The table that the page saves. */
export async function table(page) {
  const download = page.waitForEvent('download');
  await press(page, 'hand-ins-csv');
  return readFile(await (await download).path(), 'utf8');
}

/** Waits until no hand-in waits for its grade. */
export const isGraded = (page) =>
  page.waitForFunction(() => {
    const screen = document.querySelector('#robotran-words');
    const isAtWork = /Waiting/.test(screen.textContent) || screen.querySelector('[data-tag="hand-ins-cancel"]');
    return /Cannot be used/.test(screen.textContent) && !isAtWork;
  });

/** Waits until all workers have ended. */
export const haveEnded = async (page) => {
  while (page.workers().length > 0) await page.workers()[0].waitForEvent('close');
};

/** The table that the JVM makes of the class. */
export const expected = ({ folder } = RCX) => readFile(path.join(folder, 'grades.csv'), 'utf8');

/** Fails unless the grades of a page in which `harm` has run lack one row. */
export const costsItsRow = (harm) =>
  onPage({ ...TABLET, prepare: harm }, async ({ page }) => {
    await grade(page);
    await isGraded(page);
    const wanted = (await expected()).split('\r\n');
    const lines = (await table(page)).split('\r\n');
    assert.equal(lines.length, wanted.length);
    const different = lines.filter((line) => !wanted.includes(line));
    assert.equal(different.length, 1, different.join('\n'));
    assert.match(different[0], /could not be graded/);
  });
