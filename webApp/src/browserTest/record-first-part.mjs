// Walks through the first minute in a page whose modules mark the functions that are called, and adds a line for each of
// these to the file CALLS: the module and the index of the function. For ./gradlew :webApp:recordFirstPart.
import { appendFile } from 'node:fs/promises';
import { startBrowser } from './browser.mjs';
import { serve } from './serve.mjs';
import { appears, PATIENCE, placeOf, reports } from './words.mjs';

const FINGER = { hasTouch: true, isMobile: true };
const SCREENS = [
  { width: 411, height: 891, ...FINGER },
  { width: 891, height: 411, ...FINGER },
  { width: 820, height: 1180, ...FINGER },
  { width: 1280, height: 800, ...FINGER },
  { width: 1280, height: 800 },
];

const SLOW = { offline: false, latency: 40, downloadThroughput: 2_500_000, uploadThroughput: 1_250_000 };

/** Further sizes, which have layouts of their own. */
const OTHERS = [
  { width: 360, height: 640, ...FINGER },
  { width: 768, height: 1024, ...FINGER },
  { width: 1024, height: 768, ...FINGER },
  { width: 1180, height: 820, ...FINGER },
  { width: 1024, height: 640 },
  { width: 1366, height: 768 },
  { width: 1920, height: 1080 },
];
const LANGUAGES = ['en-GB', 'de-AT', 'es-MX', 'fr-FR', 'pt-BR'];

const browser = await startBrowser();
const site = await serve(process.env.PAGE);

/** Runs in the page: keeps the marks of each module, by the name of its file. */
function keepMarks() {
  globalThis.marks = {};
  // While a later part is missing, the page lets no mouse through that only moves, see `parts.js`.
  for (const type of ['pointermove', 'pointerenter', 'pointerleave'])
    addEventListener(type, (event) => event.buttons === 0 && event.stopImmediatePropagation(), { capture: true });
  const names = new WeakMap();
  const compile = WebAssembly.compileStreaming.bind(WebAssembly);
  WebAssembly.compileStreaming = async (source, options) => {
    const response = await source;
    const module = await compile(response, options);
    names.set(module, /([\w-]+)\.\w+\.wasm$/.exec(response.url)[1]);
    return module;
  };
  const instantiate = WebAssembly.instantiate.bind(WebAssembly);
  WebAssembly.instantiate = async (module, imports) => {
    const instance = await instantiate(module, imports);
    if (instance.exports?.called) globalThis.marks[names.get(module)] = new Uint8Array(instance.exports.called.buffer);
    return instance;
  };
}

async function record(page) {
  const called = await page.evaluate(() =>
    Object.entries(globalThis.marks).flatMap(([name, marks]) =>
      Array.from(marks, (mark, index) => (mark ? `${name} ${index}\n` : '')).filter(Boolean),
    ),
  );
  await appendFile(process.env.CALLS, called.join(''));
}

/** How long somebody looks at the page before doing anything, in milliseconds: animations come to their end meanwhile. */
const LOOKING = 12_000;

/** For how long a button is held, in milliseconds, one after the other: its ripple is drawn in another way as it grows. */
const HELD = [30, 150, 300, 600];
let walks = 0;

async function hold(page, tag, hasTouch) {
  const { x, y } = await placeOf(page, tag);
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, touchPoints) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints });
  if (hasTouch) {
    await touch('touchStart', [{ x, y }]);
  } else {
    await page.mouse.move(x, y);
    await page.mouse.down();
  }
  await page.waitForTimeout(HELD[walks++ % HELD.length]);
  await (hasTouch ? touch('touchEnd', []) : page.mouse.up());
}

/** Runs in the page: what another tab in front of it does, and leaving it. */
function goAway() {
  Object.defineProperty(document, 'visibilityState', { get: () => 'hidden', configurable: true });
  document.dispatchEvent(new Event('visibilitychange'));
  dispatchEvent(new Event('pagehide'));
  delete document.visibilityState;
  document.dispatchEvent(new Event('visibilitychange'));
}

/**
 * Opens the page as somebody who comes for the first time, chooses `view` on the greeting, and uses the page, at once or,
 * with a slow network, after having looked at it.
 */
async function walk({ view, wish, locale, colorScheme = 'light', isSlow = false, ...screen }) {
  const { width, height, ...more } = screen;
  const context = await browser.newContext({ viewport: { width, height }, locale, colorScheme, serviceWorkers: 'block', ...more });
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  // Texts and fonts that come late are another way through the app.
  if (isSlow) {
    const devtools = await context.newCDPSession(page);
    await devtools.send('Network.enable');
    await devtools.send('Network.emulateNetworkConditions', SLOW);
  }
  page.on('pageerror', (error) => console.log(String(error)));
  await page.addInitScript(keepMarks);
  let goOn = () => undefined;
  // What is chosen on the greeting is chosen before the app is there.
  if (wish) {
    const chosen = new Promise((resolve) => {
      goOn = resolve;
    });
    await page.route('**/files/robotran.*.wasm', (route) => chosen.then(() => route.continue()));
  }
  await page.goto(site.address, { waitUntil: 'commit' });
  if (wish) {
    await page.check(`[name="view"][value="${view}"]`);
    await page.click(`[data-wish="${wish}"]`);
    goOn();
  } else {
    await appears(page, 'first-run');
    if (isSlow) {
      await page.waitForTimeout(LOOKING);
      await page.evaluate(goAway);
    }
    await hold(page, 'try-square', more.hasTouch);
  }
  await page.waitForFunction(() => globalThis.robotran);
  await reports(page, (report) => report.status === 'ended');
  await appears(page, 'notice-action');
  if (isSlow) await page.waitForTimeout(LOOKING);
  await page.evaluate(goAway);
  await page.waitForTimeout(1_000);
  await record(page);
  await context.close();
}

// A language adds its sentences, whatever the screen: each screen in one language, the phone in all.
for (const [number, screen] of SCREENS.entries()) await walk({ ...screen, locale: LANGUAGES[number] });
for (const locale of LANGUAGES.slice(1)) await walk({ ...SCREENS[0], locale });
for (const screen of [SCREENS[0], SCREENS[4]]) await walk({ ...screen, locale: 'en-US', isSlow: true });
for (const screen of OTHERS) await walk({ ...screen, locale: 'en-GB' });
for (const view of ['blocks', 'text'])
  for (const screen of [SCREENS[0], SCREENS[4]]) await walk({ ...screen, view, wish: 'square', locale: 'en-GB', colorScheme: 'dark' });
await browser.close();
site.stop();
