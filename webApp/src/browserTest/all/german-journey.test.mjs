// Pupils in their own words: from the first lesson to a grade in German, by a teacher in Spanish, and a lesson in French on a phone.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { blockSaying, fingerOn } from '../blocks.mjs';
import { asTeacher, chosen, downloaded, openFile, showText, type } from '../class.mjs';
import { journeyOf } from '../journey.mjs';
import { isKept } from '../kept.mjs';
import { linkTo } from '../link.mjs';
import { isReady, photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, isSaid, programText, reports, says } from '../words.mjs';

const FINGERS = { hasTouch: true, acceptDownloads: true, pause: 20 };
const PUPIL = { ...TABLET, height: 1240, ...FINGERS, welcome: true, locale: 'de-DE' };
const TEACHER = { width: 1180, height: 820, ...FINGERS, locale: 'es-ES' };

const root = new URL('../../../../', import.meta.url);

/** The assignment of a Spanish teacher who has solved it in English words. */
async function assignment() {
  const solution = await readFile(new URL('learning/worlds/maze/solution.robo', root), 'utf8');
  const maze = JSON.parse(await readFile(new URL('worlds/maze.world.json', root), 'utf8'));
  const project = {
    format: 'robotran-project',
    version: 1,
    world: { ...maze, title: 'El laberinto', task: 'Lleva el robot hasta la bandera.' },
    robots: [{ name: 'yellow', programs: [{ name: 'laberinto.robo', language: 'robolang', text: ['beep'] }] }],
    assignment: {
      id: 'laberinto-1',
      text: ['Saca al robot del laberinto.'],
      languages: ['robolang'],
      words: 'power left right forward backward turn repeat forever start wait until bumper or if else end beep'.split(' '),
    },
  };
  const withSolution = {
    ...project.assignment,
    checks: { seeds: { from: 1, to: 1 } },
    solution: [{ name: 'laberinto.robo', language: 'robolang', text: solution.trim().split('\n') }],
  };
  return { link: linkTo('p', project), teacherFile: JSON.stringify({ ...project, assignment: withSolution }) };
}

/** Writes a line above the program key by key, with a mistake, which the page tells in German and puts right. */
async function writeAbove(page, finger) {
  await finger.press('program');
  await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
  await page.keyboard.press('Control+Home');
  await page.keyboard.type('piepse');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Enter');
  await page.keyboard.type('vorwärs 1');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Enter');
  await isSaid(page, /Es gibt keinen Befehl .vorwärs/);
  await says(page, 'fix', /vorwärts/);
  await photograph(page, 'journey-mistake-de');
  await finger.press('fix');
  await disappears(page, 'fix');
}

/** Hands the program `text` in for the assignment of `link`, and returns the file. */
async function handIn(page, finger, { link, text, folder }) {
  await page.goto('about:blank');
  await page.goto(link);
  await isReady(page);
  await isSaid(page, /Saca al robot del laberinto/);
  await photograph(page, 'journey-assignment-de');
  await showText(page, finger);
  await type(page, finger, 'program', text);
  await finger.press('run');
  await appears(page, 'solved-hand-in');
  await photograph(page, 'journey-solved-de');
  await finger.press('solved-hand-in');
  await type(page, finger, 'hand-in-name', 'Jörg');
  await photograph(page, 'journey-hand-in-de');
  await finger.press('hand-in-go-on');
  await appears(page, 'hand-in-ready');
  await photograph(page, 'journey-ready-de');
  return downloaded(page, folder, () => finger.press('hand-in-file'));
}

test('five lessons and the maze in German blocks, the maze in German text, and its grade from a teacher in Spanish', { timeout: 900_000 }, async () => {
  const folder = await mkdtemp(path.join(tmpdir(), 'journey-'));
  const { link, teacherFile } = await assignment();
  const assigned = path.join(folder, 'laberinto.robotran');
  await writeFile(assigned, teacherFile);

  let handedIn = '';
  await onPage(PUPIL, async ({ page, troubles, site }) => {
    const finger = fingerOn(page);
    const journey = journeyOf(page, finger, 'de');
    await appears(page, 'first-run');
    await photograph(page, 'journey-welcome-de');
    await journey.buildFirstSteps();
    await journey.buildMaze();

    await showText(page, finger);
    await photograph(page, 'journey-text-de');
    assert.match(await programText(page), /^kraft links 5\nkraft rechts 1\nwiederhole endlos\n {2}starte vorwärts\n {2}warte bis/);
    await writeAbove(page, finger);
    const text = await programText(page);
    assert.match(text, /^piepse\nvorwärts 1\n/);
    await isKept(page, 'vorwärts 1');
    await journey.meetsGoals();
    await photograph(page, 'journey-maze-de');

    handedIn = await handIn(page, finger, { link: site.address + link, text, folder });
    assert.deepEqual(troubles, []);
  });
  assert.match(await readFile(handedIn, 'utf8'), /warte bis linker fühler oder rechter fühler/);

  await onPage(TEACHER, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    await chosen(page, [assigned], () => openFile(page, finger));
    await appears(page, 'assignment-edit');
    await photograph(page, 'journey-teacher-es');
    await asTeacher(page, finger, 'teachers-hand-ins');
    await appears(page, 'hand-ins-empty');
    await chosen(page, [handedIn], () => finger.press('hand-ins-choose'));
    await isSaid(page, /1 Resuelta/);
    await photograph(page, 'journey-table-es');
    const csv = await readFile(await downloaded(page, folder, () => finger.press('hand-ins-csv')), 'utf8');
    assert.match(csv, /Jörg;resuelta;1;1;/);
    await finger.press('hand-in-row-0');
    await appears(page, 'hand-in-comment');
    await photograph(page, 'journey-one-es');
    assert.deepEqual(troubles, []);
  });
});

test('a phone in French builds the first lesson in French blocks, with a decimal comma on its number pad', () =>
  onPage({ width: 360, height: 640, ...FINGERS, isMobile: true, welcome: true, locale: 'fr-FR' }, async ({ page, troubles }) => {
    const finger = fingerOn(page);
    const journey = journeyOf(page, finger, 'fr');
    await appears(page, 'first-run');
    await photograph(page, 'journey-welcome-fr');
    await journey.beginTutorial();
    await photograph(page, 'journey-lesson-fr');
    await journey.hurry();
    await journey.buildFirstStep({ isAllInSight: false });

    await journey.goToBlocks();
    const { builder } = journey;
    await builder.goTo(/^avance 25/);
    await builder.add(['drive', 'move']);
    await builder.openSocket(/^avance 20/, /^20/, 0);
    await says(page, 'digit-.', /Virgule/);
    await photograph(page, 'journey-pad-fr');
    await builder.typeNumber(3.5);
    await blockSaying(page, /^avance 3,5/);
    await photograph(page, 'journey-comma-fr');
    await isKept(page, 'avance 3.5');
    await finger.press('run');
    await reports(page, (now) => now.status === 'ended');
    assert.deepEqual(troubles, []);
  }));
