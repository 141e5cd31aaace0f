// How long the built page takes from a touch to the first frame that shows what it does, by hand:
// ./gradlew :webApp:measurePage -Pmeasure=touches
import { isReady, putWelcomeAway } from './page.mjs';
import { appears, disappears, placeOf, tap, words } from './words.mjs';

const TABLET = { width: 1180, height: 820 };
const TIMES = 20;

/** Runs in the page: notes when a finger goes up or a key goes down, and when each frame of the app begins and ends. */
function watchTouches() {
  const noted = { frames: [], input: 0 };
  globalThis.robotranTouches = noted;
  for (const kind of ['pointerup', 'keydown']) {
    globalThis.addEventListener(kind, (event) => (noted.input = event.timeStamp), { capture: true });
  }
  const ask = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (callback) =>
    ask((time) => {
      const begin = performance.now();
      callback(time);
      noted.frames.push([begin, performance.now()]);
    });
}

/** The number block of the first `forward`. */
const firstNumber = (page) =>
  page.evaluate(() => {
    const sockets = [...document.querySelectorAll('#robotran-words [data-tag^="socket-"]')];
    return sockets.find((socket) => /\d/.test(socket.getAttribute('aria-label') ?? socket.textContent)).dataset.tag;
  });

const inBlocks = async (page) => {
  await tap(page, 'view-switch');
  await tap(page, 'view-blocks');
  await appears(page, 'block-0');
};

const inText = async (page) => {
  await tap(page, 'view-switch');
  await tap(page, 'view-text');
  await tap(page, 'program');
};

const leave = (tag) => async (page) => {
  await page.keyboard.press('Escape');
  await disappears(page, tag);
};

/** What is touched, the tag that then is there, and what puts it away again. */
const CASES = [
  { name: 'a number pad', prepare: inBlocks, touched: firstNumber, effect: 'block-sheet', leave: leave('block-sheet') },
  { name: 'the menu', touched: () => 'menu', effect: 'menu-settings', leave: leave('menu-settings') },
  { name: 'Worlds', touched: () => 'worlds', effect: 'world-square', leave: leave('world-square') },
  {
    name: 'the map of lessons',
    touched: async (page) => {
      await tap(page, 'menu');
      return 'menu-map';
    },
    effect: 'lesson-first-drive',
    leave: leave('lesson-first-drive'),
  },
  {
    name: 'the world editor',
    touched: () => 'edit-world',
    effect: 'edit-done',
    leave: async (page) => {
      await tap(page, 'edit-done');
      await disappears(page, 'edit-done');
    },
  },
];

/**
 * The time from the last input to the end of the first frame that worked more than `empty`, which shows what the input does; to the end of the longest
 * one, which has all of it; and the work of all frames since.
 */
const sinceInput = (page, empty) =>
  page.evaluate((nothing) => {
    const { frames, input } = globalThis.robotranTouches;
    const since = frames.filter(([begin]) => begin >= input);
    const workOf = ([begin, end]) => end - begin;
    const longest = since.reduce((most, frame) => (workOf(frame) > workOf(most) ? frame : most));
    const first = since.find((frame) => workOf(frame) > nothing) ?? longest;
    const work = since.reduce((sum, frame) => sum + workOf(frame), 0);
    return { wait: first[1] - input, whole: longest[1] - input, work };
  }, empty);

const rest = (page) =>
  page.evaluate(async () => {
    for (let frame = 0; frame < 10; frame++) await new Promise((resolve) => requestAnimationFrame(resolve));
    globalThis.robotranTouches.frames.length = 0;
  });

/** One touch, from the finger down to what it does. */
async function once(page, { touched, effect, leave: putAway }, empty) {
  const { x, y } = await placeOf(page, await touched(page));
  await rest(page);
  await page.touchscreen.tap(x, y);
  await appears(page, effect);
  const measured = await sinceInput(page, empty);
  await putAway(page);
  return measured;
}

/** One letter, and its removal, in the text editor. */
async function key(page, letter, empty = 0) {
  await rest(page);
  await page.keyboard.press(letter);
  await page.evaluate(async () => {
    for (let frame = 0; frame < 3; frame++) await new Promise((resolve) => requestAnimationFrame(resolve));
  });
  return sinceInput(page, empty);
}

const at = (values, part) => {
  const sorted = [...values].sort((one, other) => one - other);
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))].toFixed(0);
};

function tell(name, measured, first) {
  const all = (part) => measured.map((each) => each[part]);
  const spread = `${at(all('wait'), 0.5)} ms in the middle, ${at(all('wait'), 0.95)} ms at 95 %`;
  const whole = `all of it after ${at(all('whole'), 0.5)} and ${at(all('whole'), 0.95)} ms`;
  const firstOne = first ? `; the first time ${first.wait.toFixed(0)} ms` : '';
  console.log(`${name}: ${spread}, ${whole}, frames worked ${at(all('work'), 0.5)} ms${firstOne} (${measured.length})`);
}

/**
 * Prints, for each of the cases, the time of the middle and the 95th of a hundred touches, from twenty of them. A key that does nothing tells what an
 * empty frame costs on this machine.
 */
export async function measureTouches(browser, site) {
  const context = await browser.newContext({ viewport: TABLET, hasTouch: true, serviceWorkers: 'block' });
  await context.addInitScript(watchTouches);
  const page = await context.newPage();
  await page.goto(site.address);
  await isReady(page);
  if ((await words(page, 'first-run').count()) > 0) await putWelcomeAway(page);
  // The rest of the page comes after the first picture.
  await page.waitForFunction(() => !document.getElementById('parts'), null, { timeout: 120_000 });
  const times = (measure) => Array.from({ length: TIMES }).reduce(
    async (before, _, time) => [...(await before), await measure(time)],
    Promise.resolve([]),
  );
  await inText(page);
  const nothing = await times(() => key(page, 'Shift'));
  tell('a key that does nothing', nothing);
  const empty = 2 * Number(at(nothing.map(({ work }) => work), 0.95)) + 1;
  tell('a key in the text editor', await times((time) => key(page, time % 2 ? 'Backspace' : '5', empty)));
  for (const example of CASES) {
    await example.prepare?.(page);
    const first = await once(page, example, empty);
    tell(example.name, await times(() => once(page, example, empty)), first);
  }
  await context.close();
}
