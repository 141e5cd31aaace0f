// A class without a server, by touch: a teacher sets a task, pupils do it in blocks and in Java and hand in, the teacher grades
// and answers.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { builderWith, fingerOn } from '../blocks.mjs';
import { asTeacher, chosen, downloaded, openFile, showText, type } from '../class.mjs';
import { isKept, savedProjects } from '../kept.mjs';
import { linkTo } from '../link.mjs';
import { isReady, photograph, reload } from '../page.mjs';
import { onPage, PHONE } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, isSaid, says, words } from '../words.mjs';

const FINGERS = { hasTouch: true, acceptDownloads: true, permissions: ['clipboard-read', 'clipboard-write'] };
const TEACHER = { width: 1180, height: 820, ...FINGERS };
const PUPIL = { ...PHONE, ...FINGERS, locale: 'de-DE' };

const SECOND = { width: 1024, height: 768, ...FINGERS };

/** Drives ahead for `milliseconds`, and a little before and after. */
const javaFor = (milliseconds) => `import josx.platform.rcx.*;

public class Program {
    public static void main(String[] args) throws Exception {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(${milliseconds});
        Motor.A.stop();
        Motor.C.stop();
    }
}
`;

const world = {
  format: 'robotran-world',
  version: 2,
  title: 'To the mark',
  task: 'Drive to the mark.',
  paper: { width: 100, height: 80 },
  robots: [{ start: { x: 30, y: 40, heading: 0 } }],
  goals: [{ kind: 'reach', region: { rectangle: { x: 60, y: 30, width: 20, height: 20 } } }],
  timeLimit: 20,
};
const worldLink = linkTo('w', world);

/** Shows the card of the task, which may be hidden after a reload, with the tries. */
async function showTask(page, finger) {
  for (let attempt = 0; attempt < 5; attempt++) {
    try {
      await words(page, 'assignment-tries').waitFor({ state: 'attached', timeout: 6_000 });
      return;
    } catch {
      await finger.press('task-chip');
    }
  }
  await appears(page, 'assignment-tries');
}

test('a class from the assignment to the feedback, by touch', { timeout: 600_000 }, async () => {
  const folder = await mkdtemp(path.join(tmpdir(), 'class-'));
  let link = '';
  let teacherFile = '';

  await onPage({ ...TEACHER, address: worldLink }, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    await showText(page, finger);
    await type(page, finger, 'program', '// Drive to the mark.\n');
    await asTeacher(page, finger, 'teachers-make');
    await appears(page, 'assignment-make');
    await type(page, finger, 'make-text', 'The mark is 40 cm ahead.\n\n`forward` takes centimetres.');
    await type(page, finger, 'make-name', 'First name');
    await photograph(page, 'class-make');
    await page.goBack();
    await disappears(page, 'assignment-make');
    await type(page, finger, 'program', 'forward 39\n');
    await asTeacher(page, finger, 'teachers-make');
    // What was written beside the program to begin with is the solution.
    await says(page, 'make-solution', /ticked programs are the solution/);
    await finger.press('make-seeds-5');
    await finger.press('make-check');
    await appears(page, 'make-checked');
    await finger.press('make-pupil-link');
    await appears(page, 'make-link-copy');
    await photograph(page, 'class-give');
    await finger.press('make-link-copy');
    await says(page, 'make-link-copy', /copied/);
    link = await page.evaluate(() => navigator.clipboard.readText());
    await finger.press('qr-show-large');
    await appears(page, 'qr-large-view');
    await photograph(page, 'class-code');
    await page.keyboard.press('Escape');
    await disappears(page, 'qr-large-view');
    teacherFile = await downloaded(page, folder, () => finger.press('make-teacher-file'));
    assert.deepEqual(troubles, []);
  });
  assert.match(link, /#p=a/);
  assert.match(teacherFile, /To the mark \(with solution\)\.robotran$/);
  assert.match(await readFile(teacherFile, 'utf8'), /"solution"/);

  let handIn = '';
  await onPage({ ...PUPIL, address: new URL(link).hash }, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    await isSaid(page, /40 cm ahead/);
    await photograph(page, 'class-task');
    await finger.press('run');
    await appears(page, 'missing-card');
    await photograph(page, 'class-failed');
    await finger.press('tab-program');
    await finger.press('view-switch');
    await finger.press('view-blocks');
    await appears(page, 'block-0');
    const builder = builderWith(page, finger);
    await builder.add(['drive', 'move']);
    await builder.setNumber(/20 cm/, /^20 cm/, 38);
    await photograph(page, 'class-blocks');
    await finger.press('run');
    await appears(page, 'solved-hand-in');
    await photograph(page, 'class-solved');
    await finger.press('solved-hand-in');
    await type(page, finger, 'hand-in-name', 'Änne');
    await photograph(page, 'class-hand-in');
    await finger.press('hand-in-go-on');
    await appears(page, 'hand-in-ready');
    await photograph(page, 'class-ready');
    handIn = await downloaded(page, folder, () => finger.press('hand-in-file'));
    assert.deepEqual(troubles, []);
  });
  assert.match(handIn, /To the mark - Änne\.robotran$/);
  const handedIn = JSON.parse(await readFile(handIn, 'utf8'));
  assert.equal(handedIn.handIn.name, 'Änne');
  assert.deepEqual([handedIn.handIn.tries, handedIn.handIn.result.goalsMet], [2, 1]);
  assert.equal(handedIn.assignment.solution, undefined);

  let second = '';
  await onPage({ ...SECOND, address: new URL(link).hash }, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    await isSaid(page, /40 cm ahead/);
    await finger.press('add-program');
    await finger.press('new-java');
    await appears(page, 'program-1');
    await type(page, finger, 'program', javaFor(500));
    await finger.press('run');
    await says(page, 'assignment-tries', /1 try/);
    await isKept(page, 'sleep(500)');
    await type(page, finger, 'program', javaFor(4500));
    await isKept(page, 'sleep(4500)');
    // Neither reloading nor the link loses anything.
    await reload(page);
    await showTask(page, finger);
    await says(page, 'assignment-tries', /1 try/);
    await appears(page, 'program-1');
    await page.goto('about:blank');
    await page.goto(link);
    await isReady(page);
    await says(page, 'notice-text', /worked on this assignment before/);
    await photograph(page, 'class-again');
    await finger.press('notice-action');
    await appears(page, 'program-1');
    await showTask(page, finger);
    await says(page, 'assignment-tries', /1 try/);
    assert.equal((await savedProjects(page)).filter((text) => text.includes('sleep(4500)')).length, 1);
    await finger.press('program-1');
    await finger.press('run');
    await appears(page, 'solved-hand-in');
    await photograph(page, 'class-java');
    await finger.press('solved-hand-in');
    await type(page, finger, 'hand-in-name', 'Dora');
    await finger.press('hand-in-go-on');
    await appears(page, 'hand-in-ready');
    second = await downloaded(page, folder, () => finger.press('hand-in-file'));
    await finger.press('hand-in-close');
    await reload(page);
    await showTask(page, finger);
    await says(page, 'assignment-tries', /2 tries/);
    await says(page, 'assignment-handed-in', /Dora/);
    assert.deepEqual(troubles, []);
  });
  assert.match(await readFile(second, 'utf8'), /"language": "java"/);

  const lazy = path.join(folder, 'Ben.robo');
  await writeFile(lazy, 'repeat forever\nend\n');
  const broken = path.join(folder, 'Caro.zip');
  await writeFile(broken, Buffer.from('PK\u0003\u0004 nothing else'));
  let feedback = '';
  await onPage(TEACHER, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    await chosen(page, [teacherFile], () => openFile(page, finger));
    await appears(page, 'assignment-edit');
    await asTeacher(page, finger, 'teachers-hand-ins');
    await appears(page, 'hand-ins-empty');
    await chosen(page, [handIn, second, lazy, broken], () => finger.press('hand-ins-choose'));
    await isSaid(page, /2 Solved/);
    await isSaid(page, /1 Not solved/);
    await isSaid(page, /1 Cannot be used/);
    await photograph(page, 'class-table');
    const csv = await readFile(await downloaded(page, folder, () => finger.press('hand-ins-csv')), 'utf8');
    assert.equal(csv.trim().split('\n').length, 5, csv);
    const html = await readFile(await downloaded(page, folder, () => finger.press('hand-ins-html')), 'utf8');
    assert.match(html, /Änne/);
    assert.doesNotMatch(html, /<script/);
    // Who needs help comes first.
    await finger.press('hand-in-row-2');
    await appears(page, 'hand-in-comment');
    await type(page, finger, 'hand-in-comment', 'Well done, Änne.');
    await photograph(page, 'class-one');
    feedback = await downloaded(page, folder, () => finger.press('hand-in-feedback'));
    await finger.press('hand-in-replay');
    await disappears(page, 'hand-in-comment');
    await photograph(page, 'class-replay');
    assert.deepEqual(troubles, []);
  });

  await onPage(PUPIL, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    await finger.press('menu');
    await chosen(page, [feedback], () => openFile(page, finger));
    await isSaid(page, /Well done, Änne/);
    await isSaid(page, /Vorgegebene Welt/);
    await photograph(page, 'class-feedback');
    assert.equal(await words(page, 'assignment-hand-in').count(), 0);
    assert.deepEqual(troubles, []);
  });
});

/** Runs in the page: what a camera makes, 4000 points wide and too long for a task, in Base64. */
async function photo() {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [4_000, 3_000];
  const context = canvas.getContext('2d');
  for (let place = 0; place < 20_000; place += 1) {
    context.fillStyle = `hsl(${(place * 137) % 360} 70% ${(place * 31) % 100}%)`;
    context.fillRect((place * 7919) % 4_000, (place * 104_729) % 3_000, 60, 40);
  }
  const file = await new Promise((resolve) => canvas.toBlob(resolve, 'image/jpeg', 0.95));
  const bytes = new Uint8Array(await file.arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

test('a photo for a task is made smaller, and one that the browser cannot read is told with what to do', () =>
  onPage({ ...TEACHER, address: worldLink }, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    const jpeg = Buffer.from(await page.evaluate(photo), 'base64');
    assert.ok(jpeg.length > 1_000_000, `${jpeg.length} bytes`);
    const file = (name, buffer) => ({ name, mimeType: 'application/octet-stream', buffer });
    await asTeacher(page, finger, 'teachers-make');
    await appears(page, 'make-picture');
    await chosen(page, [file('IMG_1.HEIC', Buffer.from('\0\0\0\x18ftypheic\0\0\0\0mif1heic'))], () =>
      finger.press('make-picture'),
    );
    await says(page, 'make-picture-error', /HEIC/);
    await chosen(page, [file('IMG_2.JPG', jpeg)], () => finger.press('make-picture'));
    await says(page, 'make-picture-smaller', /made smaller/);
    await appears(page, 'make-picture-remove-0');
    await disappears(page, 'make-picture-error');
    await photograph(page, 'class-photo');
    assert.deepEqual(troubles, []);
  }));
