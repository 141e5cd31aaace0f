// Hand-ins are graded in workers, with the same results as on the JVM, and the page stays alive meanwhile.
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import path from 'node:path';
import { onPage, TABLET } from './set-up.mjs';
import { test } from './tried-again.mjs';
import { appears, choose, disappears, press, says } from './words.mjs';

const grades = process.env.EXPECTED_GRADES;

// Classes of hand-ins, good, bad and hostile ones, with the grades that the JVM gives them.
const RCX = { folder: grades, assignment: 'parking.robotran', title: /Parking/ };
const NXT = { folder: path.join(grades, 'nxt'), assignment: 'wall.robotran', title: /Before the wall/ };

const file = async (name) => ({
  name: path.basename(name),
  mimeType: 'application/octet-stream',
  buffer: await readFile(name),
});

/** Opens the assignment and lets the page grade the class. */
async function grade(page, { folder, assignment, title } = RCX) {
  let chooser = page.waitForEvent('filechooser');
  await choose(page, 'work-menu', 'work-open');
  await (await chooser).setFiles([await file(path.join(folder, assignment))]);
  await says(page, 'task-title', title);
  await choose(page, 'work-menu', 'work-hand-ins');
  chooser = page.waitForEvent('filechooser');
  await press(page, 'hand-ins-choose');
  const names = (await readdir(path.join(folder, 'class'))).sort();
  await (await chooser).setFiles(await Promise.all(names.map((name) => file(path.join(folder, 'class', name)))));
  // Until then, hand-ins that cannot be used may be there alone.
  await appears(page, 'hand-ins-cancel');
}

/** The table that the page saves. */
async function table(page) {
  const download = page.waitForEvent('download');
  await press(page, 'hand-ins-csv');
  return readFile(await (await download).path(), 'utf8');
}

/** Waits until no hand-in waits for its grade. */
const isGraded = (page) =>
  page.waitForFunction(
    () => {
      const screen = document.querySelector('#robotran-words');
      const isAtWork = /Waiting/.test(screen.textContent) || screen.querySelector('[data-tag="hand-ins-cancel"]');
      return /Cannot be used/.test(screen.textContent) && !isAtWork;
    },
    null,
    { timeout: 120_000 },
  );

const haveEnded = async (page) => {
  for (let wait = 0; page.workers().length > 0 && wait < 50; wait++) await page.waitForTimeout(100);
  assert.equal(page.workers().length, 0);
};

const expected = ({ folder } = RCX) => readFile(path.join(folder, 'grades.csv'), 'utf8');

// For the NXT, workers compile Java for leJOS NXJ: they fetch its class library themselves.
for (const [robots, handIns] of [
  ['an RCX', RCX],
  ['an NXT', NXT],
]) {
  test(`workers give a class with ${robots} the same grades as the JVM`, () =>
    onPage(TABLET, async ({ page, troubles }) => {
      const workers = [];
      page.on('worker', (worker) => workers.push(worker));
      await grade(page, handIns);
      await isGraded(page);
      assert.equal(await table(page), await expected(handIns));
      assert.ok(workers.length >= 1, `${workers.length} workers`);
      await haveEnded(page);
      assert.deepEqual(troubles, []);
    }));

  test(`without workers, the page grades a class with ${robots} in slices, with the same result`, () =>
    onPage({ ...TABLET, prepare: () => delete globalThis.Worker }, async ({ page, troubles }) => {
      await grade(page, handIns);
      await isGraded(page);
      assert.equal(await table(page), await expected(handIns));
      assert.deepEqual(troubles, []);
    }));
}

for (const [what, harm] of [
  ['dies', dies],
  ['stands still', standsStill],
]) {
  test(`a worker that ${what} costs its own row only`, () =>
    onPage({ ...TABLET, prepare: harm }, async ({ page }) => {
      await grade(page);
      await isGraded(page);
      const wanted = (await expected()).split('\r\n');
      const lines = (await table(page)).split('\r\n');
      assert.equal(lines.length, wanted.length);
      const different = lines.filter((line) => !wanted.includes(line));
      assert.equal(different.length, 1, different.join('\n'));
      assert.match(different[0], /could not be graded/);
    }));
}

/** Runs in the page: the worker of the second hand-in ends with an error. */
function dies() {
  let handIns = 0;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message) {
    // Only orders have a first seed.
    if (typeof message === 'string' && !message.includes('"first"') && (handIns += 1) === 2) {
      this.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
    } else postMessage.call(this, message);
  };
}

/** Runs in the page: the worker of the second hand-in never answers, and the page waits for seconds instead of minutes. */
function standsStill() {
  let handIns = 0;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message) {
    if (typeof message !== 'string' || message.includes('"first"') || (handIns += 1) !== 2) postMessage.call(this, message);
  };
  const wait = globalThis.setTimeout;
  globalThis.setTimeout = (action, time, ...more) => wait(action, time === 5_000 ? 500 : time, ...more);
}

test('grading can be stopped, and the rest graded later', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await grade(page);
    await press(page, 'hand-ins-cancel');
    await appears(page, 'hand-ins-go-on');
    await haveEnded(page);
    await press(page, 'hand-ins-go-on');
    await disappears(page, 'hand-ins-go-on');
    await isGraded(page);
    assert.equal(await table(page), await expected());
    assert.deepEqual(troubles, []);
  }));
