// Opens the built page for a test.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { EMPTY } from './serve.mjs';
import { PATIENCE, press, words } from './words.mjs';

/** The colour of Run on the brick. */
export const RUN_GREEN = [0x2e, 0x9e, 0x4f];

// Skiko of Compose 1.7.3 accesses the memory through a deprecated export. It works, and newer versions fix it.
// Chromium fails a request for a file that it was keeping for a page that has been left meanwhile. The page asks again.
const KNOWN_COMPLAINT = /Accessing `memory` via `wasmExports` is deprecated|ERR_CACHE_WRITE_FAILURE/;

/**
 * Opens the page and waits until the workshop is ready. `troubles` collects errors in the page and downloads from other
 * hosts, `fetched` the URLs of all downloads. The optional function `prepare` runs in the page before anything else. A
 * new context counts as a first visit; the welcome dialog is closed unless the test needs it (`welcome`). All pages of the
 * context draw only while a test looks, see `look`, or always if `drawn`; a frame comes `pause` milliseconds after the one
 * before, at the earliest. `address` is appended to the page's URL. All other options go to the browser context, which caches
 * nothing for offline use unless `serviceWorkers` is 'allow'.
 */
export async function openPage(browser, site, options) {
  const opened = await openContext(browser, site, options);
  await visit(opened, site, options);
  return opened;
}

async function openContext(
  browser,
  site,
  { width, height, dark = false, prepare, welcome, drawn = false, pause = 60, address, ...more },
) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? 'dark' : 'light',
    serviceWorkers: 'block',
    ...more,
  });
  await context.addInitScript(drawSeldom, { always: drawn, pause });
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  const troubles = [];
  const fetched = [];
  page.on('request', (request) => fetched.push(request.url()));
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on(
    'console',
    (message) => message.type() === 'error' && !KNOWN_COMPLAINT.test(message.text()) && troubles.push(message.text()),
  );
  page.on(
    'request',
    (request) =>
      request.url().startsWith(site.address) ||
      /^(data|blob):/.test(request.url()) ||
      troubles.push(`fetched ${request.url()}`),
  );
  return { page, troubles, fetched };
}

async function visit(opened, site, { prepare, welcome = false, address = '' }) {
  const { page } = opened;
  if (prepare) opened.undo = await prepared(page, prepare);
  await page.goto(site.address + address);
  await isReady(page);
  if (!welcome && (await words(page, 'first-run').count()) > 0) await putWelcomeAway(page);
}

/** Lets `prepare`, a function or a script, run in the page before anything else, until the returned function is called. */
async function prepared(page, prepare) {
  const session = await page.context().newCDPSession(page);
  const source = typeof prepare === 'function' ? `(${prepare})()` : prepare;
  await session.send('Page.enable');
  await session.send('Page.addScriptToEvaluateOnNewDocument', { source });
  return () => session.detach();
}

/** Opens the page anew for another test with the same `options`: as a first visit, without what the test before has kept. */
export async function openAgain(opened, site, options) {
  const { page, troubles, fetched } = opened;
  await opened.undo?.();
  opened.undo = undefined;
  for (const other of page.context().pages()) if (other !== page) await other.close();
  await page.setViewportSize({ width: options.width, height: options.height });
  await insistOn(() => page.goto(`${site.address}${EMPTY}`));
  await page.mouse.move(0, 0);
  await page.evaluate(async () => {
    for (const { name } of await indexedDB.databases()) {
      await new Promise((resolve, reject) => {
        const request = indexedDB.deleteDatabase(name);
        request.onsuccess = resolve;
        request.onerror = () => reject(request.error);
      });
    }
    localStorage.clear();
    sessionStorage.clear();
  });
  for (const list of [troubles, fetched]) list.length = 0;
  await visit(opened, site, options);
}

/**
 * Runs in the page: lets it draw once in `pause` milliseconds at most, and not on the screen unless a test looks (`look`). Drawing in
 * software would take most of the machine while a test only waits. What is drawn elsewhere, to be used again, is drawn.
 */
function drawSeldom({ always, pause }) {
  const ask = globalThis.requestAnimationFrame.bind(globalThis);
  let latest = -pause;
  globalThis.requestAnimationFrame = (callback) =>
    ask(function draw(time) {
      if (time !== latest && time - latest < pause) {
        ask(draw);
        return;
      }
      latest = time;
      callback(time);
    });

  globalThis.isLookedAt = always;
  const canvas = WebGL2RenderingContext.prototype;
  const screens = new Set([null]); // And what is copied to the screen.
  let [target, source] = [null, null];
  const isUnseen = () => screens.has(target) && !globalThis.isLookedAt;
  const replace = (name, replacement) => {
    const original = canvas[name];
    canvas[name] = function (...values) {
      replacement(this, values);
      if (name === 'bindFramebuffer' || !isUnseen()) original.apply(this, values);
    };
  };
  replace('bindFramebuffer', ({ READ_FRAMEBUFFER, DRAW_FRAMEBUFFER }, [kind, framebuffer]) => {
    if (kind !== READ_FRAMEBUFFER) target = framebuffer ?? null;
    if (kind !== DRAW_FRAMEBUFFER) source = framebuffer ?? null;
  });
  replace('blitFramebuffer', () => {
    if (screens.has(target)) screens.add(source);
  });
  for (const name of ['clear', 'drawArrays', 'drawElements', 'drawRangeElements']) replace(name, () => undefined);
  for (const name of ['drawArraysInstanced', 'drawElementsInstanced']) replace(name, () => undefined);
}

/**
 * Returns what `see` returns, which may take a picture of the page: makes it draw on the screen meanwhile. The app only
 * draws when something changes, such as the size of its window.
 */
export async function look(page, see) {
  const isBlind = await page.evaluate(() => globalThis.isLookedAt === false);
  const set = (isLookedAt) =>
    Promise.all(page.frames().map((frame) => frame.evaluate((is) => (globalThis.isLookedAt = is), isLookedAt)));
  if (isBlind) await set(true);
  if (isBlind) {
    const { width, height } = page.viewportSize();
    for (const each of [height - 1, height]) {
      await page.setViewportSize({ width, height: each });
      await page.evaluate(
        () =>
          new Promise((resolve) => {
            const wait = (frames) => (frames === 0 ? resolve() : requestAnimationFrame(() => wait(frames - 1)));
            wait(3);
          }),
      );
    }
  }
  try {
    return await see();
  } finally {
    if (isBlind) await set(false);
  }
}

/** Waits until the workshop exists and its accessibility nodes are there, which follow the first frame. */
export async function isReady(page) {
  await page.waitForFunction(() => globalThis.robotran !== undefined, null, { timeout: PATIENCE });
  await page.waitForFunction(() => document.querySelector('#robotran-words [data-tag]'), null, { timeout: PATIENCE });
  await page.waitForLoadState('networkidle');
}

/**
 * Loads a page as `load` does. A dialog or menu that has just closed takes its entry out of the browser's history
 * (`PageHistory`), and a service worker may just be leaving; a browser gives up what it loads for that, and is asked again.
 */
async function insistOn(load) {
  for (let attempt = 0; ; attempt++) {
    try {
      return await load();
    } catch (error) {
      if (attempt === 9 || !/ERR_ABORTED/.test(error.message)) throw error;
    }
  }
}

/** Reloads the page. */
export const loadAgain = (page) => insistOn(() => page.reload());

/** Reloads the page and waits until it is ready. */
export async function reload(page) {
  await loadAgain(page);
  await isReady(page);
}

/** Chooses text, also where there are only fingers: most tests type programs. */
export async function putWelcomeAway(page) {
  await words(page, 'first-text').waitFor({ state: 'attached' });
  if ((await words(page, 'first-text').getAttribute('aria-checked')) !== 'true') await press(page, 'first-text');
  await press(page, 'first-run-close');
  await words(page, 'first-run').waitFor({ state: 'detached' });
  // Its entry in the history goes later, and what is opened before is gone with it.
  await page.waitForFunction(() => !history.state?.robotran);
}

/** The report of the workshop's run so far. */
export const report = async (page) => JSON.parse(await page.evaluate(() => globalThis.robotran.report()));

/** Whether there are to be pictures for people to look at. */
const takesPictures = Boolean(process.env.TAKES_PICTURES);

/** Takes a picture of the page for people to look at, in the ring that has time for it. */
export const photograph = async (page, name) => takesPictures && takePicture(page, name);

export const takePicture = (page, name) =>
  look(page, () => page.screenshot({ path: path.join(process.env.PICTURES, `${name}.png`) }));

/** Runs the example FILE in the page, on BRICK if it is given, and compares it with its record in the folder RUNS, bit for bit. */
export async function assertRecordedRun(page, file, runs, brick = null) {
  const record = path.join(runs, path.parse(file).name);
  const program = await readFile(file, 'utf8');
  const run = await page.evaluate(
    ([text, name, on]) => globalThis.robotran.run(text, 60_000, name, on),
    [program, path.basename(file), brick],
  );
  // The trace hash in the report covers the whole ROM log. Only short logs are recorded as text, too.
  if (existsSync(`${record}.rom-log.txt`))
    assert.equal(run.romLog, await readFile(`${record}.rom-log.txt`, 'utf8'), file);
  assert.equal(`${run.report}\n`, await readFile(`${record}.report.json`, 'utf8'), file);
}
