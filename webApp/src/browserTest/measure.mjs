// Measures the built page in Chromium, by hand: ./gradlew :webApp:measurePage, or only some measurements with
// -Pmeasure=loading,frames,memory,keys,blocks,touches.
import { readFileSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { findColour, launchPerson, startBrowser } from './browser.mjs';
import { isReady, putWelcomeAway, RUN_GREEN } from './page.mjs';
import { serve } from './serve.mjs';
import { measureTouches } from './touch-times.mjs';
import { placeOf, words } from './words.mjs';

const SIZE = { width: 1280, height: 800 };
const NETWORK = { offline: false, latency: 40, downloadThroughput: 10e6 / 8, uploadThroughput: 10e6 / 8 };
const FRAMES_SECONDS = 20;
const KEYS = 200;
const MEMORY_MINUTES = Number(process.env.MINUTES ?? 10);

const DRIVING = [
  'pen down',
  'repeat forever',
  '  power 7',
  '  start forward',
  '  wait 625 milliseconds',
  '  if left bumper or right bumper',
  '    backward 4',
  '    turn left 100',
  '  end',
  'end',
];

const browser = await startBrowser({ optimizing: true });
const site = await serve(process.env.PAGE, { compresses: true });
const wanted = process.argv.slice(2);
const measures = (name) => wanted.length === 0 || wanted.includes(name);

const seconds = (milliseconds) => `${(milliseconds / 1000).toFixed(1)} s`;
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;

/** The median and the high percentiles of a list of numbers. */
function spread(values) {
  const sorted = [...values].sort((one, other) => one - other);
  const at = (part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))].toFixed(1);
  return `${at(0.5)} ms in the middle, ${at(0.95)} ms at 95 %, ${at(0.99)} ms at 99 %, ${sorted.at(-1).toFixed(1)} ms at most (${values.length})`;
}

/** Runs in the page: records when the app is visible, and presses Run where it was found before. */
function noteFirstPicture() {
  globalThis.moments = {};
  new MutationObserver((_, observer) => {
    if (document.getElementById('loading') || !globalThis.robotran) return;
    globalThis.moments.picture ??= performance.now();
    observer.disconnect();
  }).observe(document, { childList: true, subtree: true });
}

/** Opens the page. If `clicks` are given, closes the welcome dialog and presses Run with them. */
async function load(context, { clicks = [], slow = true }) {
  const page = await context.newPage();
  const devtools = await context.newCDPSession(page);
  await devtools.send('Network.enable');
  if (slow) await devtools.send('Network.emulateNetworkConditions', NETWORK);
  let bytes = 0;
  devtools.on('Network.loadingFinished', ({ encodedDataLength }) => {
    bytes += encodedDataLength;
  });
  await page.addInitScript(noteFirstPicture);
  await page.goto(site.address, { waitUntil: 'commit' });
  await page.waitForFunction(() => globalThis.moments.picture, null, { timeout: 120_000, polling: 20 });
  const atPicture = bytes;
  for (const { x, y } of clicks) {
    await page.mouse.click(x, y);
    await page.evaluate(
      () =>
        new Promise((resolve) =>
          requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(resolve))),
        ),
    );
  }
  if (clicks.length > 0) {
    await page.waitForFunction(() => JSON.parse(globalThis.robotran.report()).inkCentimetres > 0, null, {
      timeout: 60_000,
      polling: 20,
    });
  }
  const { picture, run } = await page.evaluate(() => ({ picture: globalThis.moments.picture, run: performance.now() }));
  return { page, bytes: atPicture, all: () => bytes, picture, run };
}

const told = ({ bytes, picture, run }) =>
  `${megabytes(bytes)} and ${seconds(picture)} to the first picture, ${seconds(run)} to the first line drawn`;

/** A browser with its own profile folder, since private windows do not cache large files between visits. */
async function newPerson(options) {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'robotran-person-'));
  const context = await launchPerson(folder, { viewport: SIZE, optimizing: true, ...options });
  return { context, leave: () => context.close().then(() => rm(folder, { recursive: true, force: true })) };
}

/** Prints what has come to `page`, the largest first. */
async function tellBudget(page) {
  await page.waitForFunction(() => !document.getElementById('parts') && navigator.serviceWorker);
  const { needed, entries } = await page.evaluate(() => ({
    needed: JSON.parse(document.getElementById('site').textContent).first.map(([address]) => address),
    entries: performance.getEntriesByType('resource').map(({ name, encodedBodySize }) => [name, encodedBodySize]),
  }));
  for (const [name, bytes] of entries.sort(([, one], [, other]) => other - one).filter(([, size]) => size > 10_000)) {
    const when = needed.some((address) => name.endsWith(address)) ? 'first' : 'later or on request';
    console.log(`  ${megabytes(bytes)} ${name.replace(/.*files./, '').replace(/\.[0-9a-f]{16}/, '')}, ${when}`);
  }
}

async function measureLoading() {
  const rehearsal = await newPerson({ serviceWorkers: 'block' });
  const { page } = await load(rehearsal.context, { slow: false });
  await isReady(page);
  const square = await placeOf(page, 'try-square');
  const close = await placeOf(page, 'first-run-close');
  await putWelcomeAway(page);
  const button = await placeOfRun(page);
  await rehearsal.leave();

  const first = await newPerson({ serviceWorkers: 'block' });
  const cold = await load(first.context, { clicks: [square] });
  console.log(`cold, 10 Mbit/s: ${told(cold)}`);
  await tellBudget(cold.page);
  const compile = await cold.page.evaluate(async () => {
    const begin = performance.now();
    await globalThis.robotran.run('public class A { public static void main(String[] a) { } }', 1000, 'A.java');
    return performance.now() - begin;
  });
  console.log(`the first Java program, with its compiler: ${seconds(compile)}, ${megabytes(cold.all())} in all`);
  await cold.page.close();
  console.log(`warm from the browser's cache, 10 Mbit/s: ${told(await load(first.context, { clicks: [button] }))}`);
  await first.leave();

  const keeping = await newPerson({});
  const visit = await load(keeping.context, { clicks: [close, button], slow: false });
  const begin = Date.now();
  await visit.page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  console.log(
    `everything kept for later: ${seconds(Date.now() - begin)} after the first picture, without a slow network`,
  );
  await visit.page.close();
  site.refuse = () => 503;
  console.log(
    `without a network, from the service worker: ${told(await load(keeping.context, { clicks: [button], slow: false }))}`,
  );
  site.refuse = () => null;
  await keeping.leave();
}

/** Runs in the page: measures the duration of each frame's callbacks and the time between frames. */
function watchFrames() {
  const frames = { work: [], between: [], last: null };
  globalThis.robotranFrames = frames;
  const ask = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (callback) =>
    ask((time) => {
      const begin = performance.now();
      callback(time);
      frames.work.push(performance.now() - begin);
      if (frames.last !== null && time > frames.last) frames.between.push(time - frames.last);
      frames.last = time;
    });
}

/** The position of Run on the brick, once it is drawn. */
async function placeOfRun(page) {
  for (let attempt = 0; attempt < 40; attempt++) {
    const place = await findColour(page, RUN_GREEN);
    if (place) return place;
    await page.waitForTimeout(250);
  }
  throw new Error('There is no Run to be seen');
}

async function openDriving(context, project) {
  const page = await context.newPage();
  await page.addInitScript(watchFrames);
  await page.goto(`${site.address}#p=a${deflateRawSync(JSON.stringify(project)).toString('base64url')}`);
  await page.waitForFunction(() => globalThis.robotran !== undefined && !document.getElementById('loading'), null, {
    timeout: 120_000,
  });
  await isReady(page);
  if ((await words(page, 'first-run').count()) > 0) await putWelcomeAway(page);
  const { x, y } = await placeOfRun(page);
  await page.mouse.click(x, y);
  await page.waitForFunction(() => JSON.parse(globalThis.robotran.report()).status === 'running', null, {
    timeout: 60_000,
  });
  return page;
}

const projectOf = (world) => ({
  format: 'robotran-project',
  version: 1,
  world,
  robots: [
    {
      name: world.robots[0].name ?? 'yellow',
      programs: [{ name: 'driving.robo', language: 'robolang', text: DRIVING }],
    },
  ],
});
const fromTree = (path) => JSON.parse(readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8'));
const plain = () => projectOf(fromTree('worlds/plain.world.json'));
const full = () => projectOf(fromTree('shared/projects/src/commonTest/resources/runs/full-of-things-0.robotran').world);

async function measureFrames() {
  for (const [name, project] of [
    ['a plain sheet', plain()],
    ['a world full of things', full()],
  ]) {
    const context = await browser.newContext({ viewport: SIZE, serviceWorkers: 'block' });
    const page = await openDriving(context, project);
    await page.evaluate(() => Object.assign(globalThis.robotranFrames, { work: [], between: [] }));
    await page.waitForTimeout(FRAMES_SECONDS * 1000);
    const { work, between } = await page.evaluate(() => globalThis.robotranFrames);
    console.log(`${name}, work of a frame: ${spread(work)}`);
    console.log(
      `${name}, from frame to frame: ${spread(between)}, ${(between.length / FRAMES_SECONDS).toFixed(0)} frames a second`,
    );
    await context.close();
  }
}

/** The resident memory of the browser's processes of this kind, in bytes. */
async function residentBytes(kind) {
  const devtools = await browser.newBrowserCDPSession();
  const { processInfo } = await devtools.send('SystemInfo.getProcessInfo');
  await devtools.detach();
  const pages = (
    await Promise.all(
      processInfo.filter(({ type }) => type === kind).map(({ id }) => readFileSync(`/proc/${id}/statm`, 'utf8')),
    )
  ).map((statm) => Number(statm.split(' ')[1]));
  return Math.max(...pages) * 4096;
}

async function measureMemory() {
  const context = await browser.newContext({ viewport: SIZE, serviceWorkers: 'block' });
  const page = await openDriving(context, full());
  const devtools = await context.newCDPSession(page);
  await devtools.send('Performance.enable');
  for (let minute = 0; minute <= MEMORY_MINUTES; minute++) {
    if (minute > 0) await page.waitForTimeout(60_000);
    await devtools.send('HeapProfiler.collectGarbage');
    const { metrics } = await devtools.send('Performance.getMetrics');
    const heap = metrics.find(({ name }) => name === 'JSHeapUsedSize').value;
    const { seconds: run } = JSON.parse(await page.evaluate(() => globalThis.robotran.report()));
    console.log(
      `after ${minute} min (${Math.round(run)} s of run): ${megabytes(heap)} of objects, ${megabytes(await residentBytes('renderer'))} of the process`,
    );
  }
  await context.close();
}

/** Measures the time from a key press until the frame with its result is drawn, for programs of these lengths. */
/** Chromium's script time of the page so far, in milliseconds, without painting. */
async function scriptTime(devtools) {
  const { metrics } = await devtools.send('Performance.getMetrics');
  return metrics.find(({ name }) => name === 'ScriptDuration').value * 1000;
}

async function measureKeys() {
  for (const characters of [200, 20_000, 199_000]) {
    const context = await browser.newContext({
      viewport: SIZE,
      serviceWorkers: 'block',
      permissions: ['clipboard-read', 'clipboard-write'],
    });
    const page = await context.newPage();
    await page.goto(site.address);
    await isReady(page);
    if ((await words(page, 'first-run').count()) > 0) await putWelcomeAway(page);
    const { x, y } = await placeOf(page, 'program');
    await page.mouse.click(x, y);
    await page.keyboard.press('Control+a');
    await page.evaluate((text) => navigator.clipboard.writeText(text), 'forward 20\n'.repeat(characters / 11));
    await page.keyboard.press('Control+v');
    await page.waitForTimeout(5_000);
    const devtools = await context.newCDPSession(page);
    await devtools.send('Performance.enable');
    const before = await scriptTime(devtools);
    const times = await page.evaluate(async (keys) => {
      const picture = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      const took = [];
      for (let key = 0; key < keys; key++) {
        await picture();
        const begin = performance.now();
        const field = document.activeElement;
        const at = field.selectionStart;
        if (key % 2) field.setRangeText('', at - 1, at, 'end');
        else field.setRangeText('5', at, at, 'end');
        field.dispatchEvent(new InputEvent('input', { inputType: key % 2 ? 'deleteContentBackward' : 'insertText' }));
        await picture();
        took.push(performance.now() - begin);
      }
      return took;
    }, KEYS);
    const script = ((await scriptTime(devtools)) - before) / KEYS;
    console.log(
      `a key in ${characters} characters: ${spread(times)}; ${script.toFixed(1)} ms of it in the page's code`,
    );
    await context.close();
  }
}

const GROUP = [
  'forward 20',
  'repeat 4 times',
  '  turn left 90',
  '  if left bumper or right bumper',
  '    backward 5 + 2 // back off',
  '  else',
  '    play 440 for 1 second',
  '  end',
  'end',
  'pen down',
];

/** Opens the page with a program of this many times GROUP, which has seven blocks, in blocks or as text. */
async function openLong(context, groups, view) {
  const page = await context.newPage();
  await page.addInitScript(watchFrames);
  const project = projectOf(fromTree('worlds/plain.world.json'));
  const text = Array(groups).fill(GROUP).flat();
  project.robots[0].programs = [{ name: 'long.robo', language: 'robolang', text, view }];
  await page.goto(`${site.address}#p=a${deflateRawSync(JSON.stringify(project)).toString('base64url')}`);
  await isReady(page);
  return page;
}

const nextFrame = (page) => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => resolve())));

/** Measures frames while a block is carried, and while long programs scroll in blocks and as text. */
async function measureBlocks() {
  const frames = 300;
  const context = await browser.newContext({ viewport: SIZE, serviceWorkers: 'block' });
  for (const [name, groups, view, begin, act] of [
    [
      'a block carried among 504',
      72,
      'blocks',
      async (page) => {
        const { x, y } = await placeOf(page, 'block-line-1');
        await page.mouse.move(x + 40, y);
        await page.mouse.down();
        return x + 60;
      },
      (page, x, frame) => page.mouse.move(x + (frame % 7), 150 + ((frame * 9) % 620)),
    ],
    ...['blocks', 'text'].map((shown) => [
      `2,000 lines scrolled in ${shown}`,
      200,
      shown,
      async (page) => {
        const { x } = await placeOf(page, shown === 'text' ? 'program' : 'block-line-1');
        await page.mouse.move(x, 500);
      },
      (page) => page.mouse.wheel(0, 60),
    ]),
  ]) {
    const page = await openLong(context, groups, view);
    const start = await begin(page);
    for (let frame = -60; frame < frames; frame++) {
      if (frame === 0) await page.evaluate(() => Object.assign(globalThis.robotranFrames, { work: [], between: [] }));
      await act(page, start, frame + 60);
      await nextFrame(page);
    }
    const { work } = await page.evaluate(() => globalThis.robotranFrames);
    // Most callbacks are the script's own; a frame of the app is longer.
    console.log(`${name}, work of a frame: ${spread(work.filter((time) => time > 0.5))}`);
    await page.close();
  }
  await context.close();
}

try {
  if (measures('loading')) await measureLoading();
  if (measures('frames')) await measureFrames();
  if (measures('memory')) await measureMemory();
  if (measures('keys')) await measureKeys();
  if (measures('blocks')) await measureBlocks();
  if (measures('touches')) await measureTouches(browser, site);
} finally {
  await browser.close();
  site.stop();
}
