// A pupil's way through the first five lessons and the maze in blocks, in any language that blocks speak.
import { areBlocks, builderWith } from './blocks.mjs';
import { isKept } from './kept.mjs';
import { photograph } from './page.mjs';
import { appears, says, words } from './words.mjs';

/**
 * What the page says in each language, and what blocks show there for pieces of a program in English. Everything else in
 * a program, such as numbers and names, is the same everywhere.
 */
export const SPOKEN = {
  en: { done: /done/, task: /^Your task$/, maze: /The maze/, allMet: /All goals met/, blocks: {} },
  de: {
    done: /geschafft/,
    task: /^Deine Aufgabe$/,
    maze: /Das Labyrinth/,
    allMet: /Alle Ziele geschafft/,
    blocks: {
      'turn left': 'drehe nach links um',
      'left bumper': 'linker fühler',
      'right bumper': 'rechter fühler',
      'wait until': 'warte bis',
      'end of': 'Ende von',
      repeat: 'wiederhole',
      times: 'mal',
      forward: 'vorwärts',
      backward: 'rückwärts',
      pen: 'stift',
      down: 'runter',
      up: 'hoch',
      power: 'kraft',
      left: 'links',
      right: 'rechts',
      for: 'für',
      from: 'von',
      to: 'bis',
      step: 'schritt',
      and: 'und',
      or: 'oder',
      else: 'sonst',
    },
  },
  fr: {
    done: /réussie/,
    task: /^Ta tâche$/,
    blocks: { 'turn left': 'tourne à gauche de', forward: 'avance', wait: 'attends' },
  },
};

/** A pupil with `hand` whose app is in `language`: what is built is written in English, as in `blocks.test.mjs`. */
export function journeyOf(page, hand, language = 'en') {
  const spoken = SPOKEN[language];
  const builder = builderWith(page, hand);

  /** A piece of a program in English, as blocks show it. */
  const shown = (piece) =>
    Object.entries(spoken.blocks).reduce((all, [english, other]) => all.replaceAll(whole(english), other), piece);
  /** What begins with `piece`. */
  const like = (piece) => new RegExp(`^${escaped(shown(piece))}`, 'i');
  /** What is nothing but `piece`. */
  const just = (piece) => new RegExp(`^${escaped(shown(piece))}$`);

  const show = (...pieces) => areBlocks(page, pieces.map(shown));
  const setNumber = (block, socket, number, skip = 0) => builder.setNumber(like(block), like(socket), number, skip);
  const picture = (name) => photograph(page, language === 'en' ? name : `${name}-${language}`);

  /** Runs the step's program, and waits until its task is done. On a phone, where the task is folded, a card says so. */
  async function solves() {
    const isFolded = (await words(page, 'task-status').count()) === 0;
    await hand.press('run');
    if (isFolded) await appears(page, 'solved-card');
    else await says(page, 'task-status', spoken.done);
  }

  /** Shows the blocks, in whose place a phone has the lesson or the world. */
  async function goToBlocks() {
    for (const tag of ['to-program', 'tab-program', 'to-program']) {
      if ((await words(page, 'block-pane').count()) > 0) return;
      if ((await words(page, tag).count()) > 0) await hand.press(tag);
    }
    await appears(page, 'block-pane');
  }

  async function goOn() {
    await hand.press('next-step');
    await says(page, 'task-status', spoken.task);
  }

  /** Opens the first step of the tutorial from the first page, which has been asked for blocks. */
  async function beginTutorial() {
    await appears(page, 'first-blocks');
    const isChosen = (await words(page, 'first-blocks').getAttribute('aria-checked')) === 'true';
    if (!isChosen) await hand.press('first-blocks');
    await hand.press('try-tutorial');
    await appears(page, 'hint-wanted');
    await goToBlocks();
  }

  /** The robot drives as fast as the machine allows, so that the test waits less for it. */
  async function hurry() {
    await hand.press('run-more');
    await hand.press('panel-speed-fastest');
    await hand.press('run-panel-close');
  }

  /** The solution of the first step, from the program that it begins with. A small phone does not show all blocks at once. */
  async function buildFirstStep({ isAllInSight = true } = {}) {
    await setNumber('forward 20 cm', '20 cm', 30);
    await builder.goTo(like('turn left'));
    await builder.add(['drive', 'move']);
    await setNumber('forward 20 cm', '20 cm', 25);
    if (isAllInSight) await show('forward 30', 'turn left 90', 'forward 25');
    await solves();
    await picture('blocks-step-1');
  }

  /** The solutions of the first five steps. */
  async function buildFirstSteps() {
    await beginTutorial();
    await hurry();
    await buildFirstStep();
    await goOn();

    await show('pen down', 'forward 20', 'pen up');
    await builder.goTo(like('pen up'));
    await builder.add(['drive', 'move'], ['pen', 'pen'], ['drive', 'move'], ['pen', 'pen']);
    await setNumber('forward 20 cm', '20 cm', 10, 1);
    await builder.choose(like('pen down'), like('down'), just('up'), 2);
    await show('pen down', 'forward 20', 'pen up', 'forward 10', 'pen down', 'forward 20', 'pen up');
    await solves();
    await picture('blocks-step-2');
    await goOn();

    await setNumber('repeat 4 times', '4', 6);
    await setNumber('turn left', '90', 60);
    await solves();
    await picture('blocks-step-3');
    await goOn();

    await builder.setNumber(/side \+ 2/, /^2/, 5);
    await solves();
    await picture('blocks-step-4');
    await goOn();

    await builder.act(like('for i from 1 to 3'), new RegExp(shown('step')));
    await setNumber('for i from 1', '1', 5);
    await setNumber('for i from 5', '3', 1);
    await setNumber('for i from 5 to 1', '2', -1);
    await builder.goTo(like('end of'));
    await builder.add(['drive', 'move']);
    await setNumber('forward 20', '20', 45);
    await solves();
    await picture('blocks-step-5');
  }

  /** Leaves the lessons, and opens the maze with an empty program in blocks. */
  async function goToMaze() {
    await hand.press('step-more');
    await hand.press('leave-tutorial');
    await hand.press('worlds');
    await hand.press('world-maze');
    await says(page, 'task-title', spoken.maze);
    await hand.press('add-program');
    await hand.press('new-robolang');
    await appears(page, 'view-switch');
    if ((await words(page, 'block-pane').count()) > 0) return;
    await hand.press('view-switch');
    await hand.press('view-blocks');
    await appears(page, 'block-pane');
  }

  /** The solution of the maze, from nothing. */
  async function buildMaze() {
    await goToMaze();
    await builder.add(['drive', 'power-of-side', 'power-of-side']);
    await builder.choose(like('power left 5'), like('left'), just('right'), 1);
    await setNumber('power right 5', '5', 1);
    await builder.add(
      ['control', 'repeat-forever'],
      ['drive', 'start-moving'],
      ['control', 'wait-until', 'else'],
      ['drive', 'move', 'turn'],
    );
    await builder.goTo(like('else'));
    await builder.add(['drive', 'move', 'turn']);
    await builder.choose(like('wait until'), like('left bumper'), just('left bumper and right bumper'));
    await builder.choose(like('wait until'), like('and'), just('or'));
    for (const [turn, distance, angle] of [
      [0, 4, 90],
      [0, 2, 25],
    ]) {
      await builder.choose(like('forward 20'), like('forward'), just('backward'), turn);
      await setNumber('backward 20', '20', distance);
      if (angle !== 90) await setNumber('turn left 90', '90', angle, 1);
    }
    await picture('blocks-maze');
    await isKept(page, shown('wait until left bumper or right bumper'));
    await meetsGoals();
  }

  /** Runs the program, and waits until all goals are met. */
  async function meetsGoals() {
    await hand.press('run');
    await says(page, 'goal-chip', spoken.allMet);
  }

  return { beginTutorial, hurry, goToBlocks, buildFirstStep, buildFirstSteps, buildMaze, meetsGoals, solves, builder };
}

/** `piece` with letters around it that are no letters. */
const whole = (piece) => new RegExp(`(?<![\\p{L}\\d])${piece}(?![\\p{L}\\d])`, 'gu');

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
