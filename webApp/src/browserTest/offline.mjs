// Visits whose files are kept for offline use, each to a server of its own.
import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { startBrowser } from './browser.mjs';
import { openPage } from './page.mjs';
import { serve } from './serve.mjs';
import { PATIENCE } from './words.mjs';

const TABLET = { width: 1280, height: 800 };
const sites = [];
let browser;

before(async () => {
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  for (const site of sites) site.stop();
});

/** A server of its own for one test. */
export async function newSite(options) {
  const site = await serve(process.env.PAGE, options);
  sites.push(site);
  return site;
}

/** Opens the page of `site`, whose service worker keeps files. */
export const openKept = (site) => openPage(browser, site, { ...TABLET, serviceWorkers: 'allow' });

/** Waits until the function, which may be async, returns true in the page. */
export async function until(page, says) {
  const end = Date.now() + PATIENCE;
  while (!(await page.evaluate(says))) {
    assert.ok(Date.now() < end, `${says} in time`);
    await page.waitForTimeout(100);
  }
}

export const isThere = (page) => page.waitForFunction(() => globalThis.robotran !== undefined, null, { timeout: PATIENCE });

/** Waits until the service worker has cached all files. */
export const isKeptOffline = (page) =>
  until(page, () =>
    navigator.serviceWorker
      .getRegistration()
      .then(
        (registration) =>
          registration?.active?.state === 'activated' && !registration.installing && !registration.waiting,
      ),
  );

const JAVA = 'public class Nothing {\n    public static void main(String[] args) {\n    }\n}\n';

export const runJava = (page) => page.evaluate((text) => globalThis.robotran.run(text, 1000, 'Nothing.java'), JAVA);
