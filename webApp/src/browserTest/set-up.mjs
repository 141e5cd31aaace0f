// One browser and one server for all tests of a file.
import { after, before } from 'node:test';
import { startBrowser } from './browser.mjs';
import { openAgain, openPage, takePicture } from './page.mjs';
import { serve } from './serve.mjs';

/** See `startBrowser`; a file of tests may change them. */
export const browserOptions = { optimizing: false };

let browser;
let failures = 0;
let site;

before(async () => {
  browser = await startBrowser(browserOptions);
  site = await serve(process.env.PAGE);
});

after(async () => {
  await browser?.close();
  site?.stop();
});

export const TABLET = { width: 1280, height: 800 };
export const PHONE = { width: 411, height: 891 };

/** The page that the test before has left, with its options: { key, opened }. */
let left = null;

/** Takes the page that was left if its options were `key`, and closes any other. */
async function takeLeft(key) {
  const taken = left;
  left = null;
  if (taken === null || taken.key === key) return taken?.opened;
  return taken.opened.page.context().close();
}

/**
 * Opens the page for a test while `use` runs; see `openPage`. To open a page costs more than most tests do in it, so it is
 * opened again for the next test with the same options.
 */
export async function onPage(options, use) {
  const { width, height, address, welcome, prepare, serviceWorkers, ...shared } = options;
  const key = serviceWorkers ? null : JSON.stringify(shared);
  let opened = await takeLeft(key);
  if (opened) await openAgain(opened, site, options);
  else opened = await openPage(browser, site, options);
  const { page } = opened;
  let isWhole = key !== null;
  page.once('crash', () => (isWhole = false));
  try {
    await use({ ...opened, site });
  } catch (error) {
    isWhole = false;
    // Shows what went wrong, in the folder of the pictures.
    await takePicture(page, `failed-${(failures += 1)}-${process.pid}`).catch(() => undefined);
    throw error;
  } finally {
    await takeLeft(null);
    if (isWhole && !page.isClosed()) left = { key, opened };
    else await page.context().close();
  }
}
