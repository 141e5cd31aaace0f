// A pupil whose app is in German builds in German blocks: by touch, from a fresh profile, and from a link.
import assert from 'node:assert/strict';
import { areBlocks, blockSaying, builderWith, fingerOn } from '../blocks.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, programText, reports, says, tap, words, writeProgram } from '../words.mjs';

const GERMAN_TABLET = { width: 1180, height: 820, hasTouch: true, locale: 'de-DE' };

/** Shows the program in blocks. */
async function inBlocks(page) {
  await appears(page, 'view-switch');
  if ((await words(page, 'block-pane').count()) > 0) return;
  await tap(page, 'view-switch');
  await tap(page, 'view-blocks');
  await appears(page, 'block-pane');
}

/** Chooses `item` in the menu of the program. */
async function choose(page, item) {
  await tap(page, 'editor-more');
  await appears(page, item);
  await tap(page, item);
  await disappears(page, item);
}

test('a program in English is built in German blocks by touch, runs, and is shown in English and rewritten in German', () =>
  onPage(GERMAN_TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'repeat 4 times\n  forward 20\n  turn left 90\nend');
    await inBlocks(page);
    await areBlocks(page, ['wiederhole 4 mal', 'vorwärts 20', 'drehe nach links um 90', 'Ende von wiederhole']);
    const builder = builderWith(page, fingerOn(page));
    await builder.choose(/^drehe/, /^links/, /^rechts/);
    await builder.goTo(/^drehe/);
    await builder.add(['control', 'wait']);
    const german = ['wiederhole 4 mal', 'vorwärts 20', 'drehe nach rechts um 90', 'warte 1 sekunde', 'Ende von wiederhole'];
    await areBlocks(page, german);
    await photograph(page, 'words-german');
    await tap(page, 'run');
    await reports(page, (now) => now.status === 'ended');
    await choose(page, 'block-words-en');
    await areBlocks(page, ['repeat 4 times', 'forward 20', 'turn right 90', 'wait 1 second', 'Ende von repeat']);
    await choose(page, 'block-words-de');
    await areBlocks(page, german);

    await tap(page, 'view-switch');
    await tap(page, 'view-text');
    await appears(page, 'program');
    assert.match(await programText(page), /^repeat 4 times\n\s+forward 20\n\s+turn right 90\n\s+wait 1 second\nend/);
    await choose(page, 'words-de');
    await says(page, 'program', /wiederhole 4 mal/);
    assert.match(await programText(page), /^wiederhole 4 mal\n\s+vorwärts 20\n\s+drehe rechts 90\n\s+warte 1 sekunde\nende/);
    await photograph(page, 'words-german-text');
    assert.deepEqual(troubles, []);
  }));

test('a link with a program in German words opens it, on a world of its own, and it runs', async () => {
  const text = ['wiederhole 2 mal', '  vorwärts 5', 'ende', 'wenn nicht linker fühler', '  piepse', 'ende'];
  const world = {
    format: 'robotran-world',
    version: 2,
    title: 'Ein Zimmer',
    paper: { width: 120, height: 80 },
    robots: [{ start: { x: 40, y: 30, heading: 90 } }],
  };
  const project = {
    format: 'robotran-project',
    version: 1,
    world,
    robots: [{ name: 'yellow', programs: [{ name: 'fahrt.robo', language: 'robolang', view: 'blocks', text }] }],
  };
  await onPage({ ...GERMAN_TABLET, address: linkTo('p', project) }, async ({ page, troubles }) => {
    await appears(page, 'block-pane');
    await blockSaying(page, /^wenn nicht linker fühler/);
    await photograph(page, 'words-german-link');
    await tap(page, 'run');
    await reports(page, (now) => now.status === 'ended');
    assert.deepEqual(troubles, []);
  });
});
