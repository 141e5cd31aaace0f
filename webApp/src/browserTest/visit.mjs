// A visit to the page from its very beginning, with one browser and one server for all tests of a file.
import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { startBrowser } from './browser.mjs';
import { serve } from './serve.mjs';
import { PATIENCE } from './words.mjs';

let browser;
/** The server; its tests may change what it answers. */
export let site;

before(async () => {
  browser = await startBrowser();
  site = await serve(process.env.PAGE);
});

after(async () => {
  await browser?.close();
  site?.stop();
});

export async function visit({ locale = 'en-GB', prepare, colorScheme = 'light', reducedMotion, route, viewport, hasTouch, isMobile, address = '' } = {}) {
  const context = await browser.newContext({
    viewport: viewport || { width: 411, height: 891 },
    locale,
    colorScheme,
    reducedMotion,
    hasTouch,
    isMobile,
    serviceWorkers: 'block',
  });
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  if (prepare) await page.addInitScript(prepare);
  if (route) await page.route(...route);
  await page.goto(site.address + address, { waitUntil: 'domcontentloaded' });
  return page;
}

/** What the page says while it loads. */
export const loadingWords = (page) => page.textContent('#loading-words');
export const appIsThere = (page) =>
  page.waitForFunction(() => globalThis.robotran !== undefined && !document.getElementById('loading'));

/** Holds the app back until the returned function is called. */
export function hold() {
  let goOn;
  const held = new Promise((resolve) => {
    goOn = resolve;
  });
  const route = [
    '**/files/robotran.*.wasm',
    async (route) => {
      await held;
      await route.continue();
    },
  ];
  return { route, goOn };
}

export const choice = (wish) => `[data-wish="${wish}"]`;

/** Chooses `wish` on the greeting, and waits until the app has carried it out, as `isDone` says. */
export async function isCarriedOut(wish, isDone) {
  const { route, goOn } = hold();
  const page = await visit({ route });
  await page.click(choice('square'));
  await page.click(choice(wish));
  assert.equal(await page.getAttribute(choice(wish), 'aria-pressed'), 'true');
  assert.match(await loadingWords(page), /begins as soon as/);
  goOn();
  await appIsThere(page);
  await isDone(page);
  await page.context().close();
}
