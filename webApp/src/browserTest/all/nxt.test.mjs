// A pupil's way through the second robot: a task from a link in both languages, the brick's own menu, a robot built by touch.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { isKept } from '../kept.mjs';
import { linkTo } from '../link.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { choose, disappears, isSaid, reports, says, tap, tapFor, writeProgram } from '../words.mjs';

const root = new URL('../../../../', import.meta.url);
const solution = (language) => readFile(new URL(`learning/worlds/nxt-square/solution.${language}`, root), 'utf8');

/** A teacher's world, which is not one of ours: the square of the NXT with another title, as a link. */
async function squareByLink(locale) {
  const world = JSON.parse(await readFile(new URL('worlds/nxt-square.world.json', root), 'utf8'));
  return linkTo('w', { ...world, title: `Das Quadrat von Frau Weber (${locale})` });
}

/** Types the program without what the editor would add by itself. */
async function write(page, text) {
  await writeProgram(page, text.replace(/^ +/gm, '').trimEnd());
}

test('a phone opens the link of a world with an NXT in German, and solves its task in Robolang', async () =>
  onPage(
    { ...PHONE, hasTouch: true, isMobile: true, locale: 'de-DE', address: await squareByLink('de') },
    async ({ page, troubles }) => {
      await says(page, 'task-title', /Das Quadrat von Frau Weber/);
      await photograph(page, 'nxt-phone-link');
      await tap(page, 'tab-program');
      await tapFor(page, 'view-switch', 'view-text');
      await tap(page, 'view-text');
      await write(page, await solution('robo'));
      await photograph(page, 'nxt-phone-program');
      await tap(page, 'run');
      await says(page, 'goal-chip', /Alle Ziele geschafft/);
      await photograph(page, 'nxt-phone-solved');
      assert.deepEqual(troubles, []);
    },
  ));

test('a tablet solves the same task in Java for leJOS NXJ, and finds its work again', async () =>
  onPage({ ...TABLET, hasTouch: true, address: await squareByLink('en') }, async ({ page, troubles }) => {
    await tap(page, 'add-program');
    await tapFor(page, 'new-java', 'program');
    await says(page, 'program', /lejos\.nxt/);
    await write(page, (await solution('java')).replace('class Turns', 'class Program'));
    await tap(page, 'run');
    await says(page, 'goal-chip', /All goals met/);
    await photograph(page, 'nxt-tablet-java-solved');
    await isKept(page, 'turnWheels');
    await reload(page);
    await tap(page, 'program-1');
    await says(page, 'program', /turnWheels/);
    assert.deepEqual(troubles, []);
  }));

test("the NXT's own buttons start the program and stop it", () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    await choose(page, 'work-menu', 'work-new-robot');
    await tap(page, 'robot-nxt');
    await writeProgram(page, 'repeat forever\nforward 10\nturn left 90\nend');
    await tap(page, 'run');
    await reports(page, (now) => now.status === 'running');
    await tap(page, 'stop');
    await tap(page, 'brick-size');
    await tap(page, 'brick-enter');
    await says(page, 'port-A', /forward/);
    await photograph(page, 'nxt-tablet-running');
    await tap(page, 'brick-escape');
    assert.deepEqual(troubles, []);
  }));

test('a robot is built by touch, what is impossible is told, and it is there again after a reload', () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    await choose(page, 'work-menu', 'work-new-robot');
    await tap(page, 'robot-nxt');
    await tap(page, 'edit-world');
    await tap(page, 'tab-edit-things');
    await tapFor(page, 'thing-robot-0', 'build-robot');
    await tapFor(page, 'build-robot', 'robot-bench');
    await photograph(page, 'workbench');
    await tap(page, 'robot-item-colour');
    await says(page, 'robot-chosen-name', /not plugged in/);
    // The light sensor has this port.
    await tap(page, 'robot-port-3');
    await isSaid(page, /Two things are plugged into port 3/);
    await photograph(page, 'workbench-impossible');
    await tap(page, 'robot-undo');
    await tap(page, 'robot-undo');
    await disappears(page, 'robot-hints-close');
    await tap(page, 'tab-robot-robot');
    await tap(page, 'robot-ready-both-sides');
    await photograph(page, 'workbench-both-sides');
    await tap(page, 'robot-done');
    await tap(page, 'edit-done');
    await isKept(page, 'both-sides');
    await reload(page);
    await tap(page, 'brick-size');
    await says(page, 'port-1', /ultrasonic/);
    await photograph(page, 'nxt-both-sides');
    assert.deepEqual(troubles, []);
  }));
