// One browser and one server for all tests of a file.
import { after, before } from 'node:test';
import { startBrowser } from './browser.mjs';
import { openPage, photograph } from './page.mjs';
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

/** Opens the page for a test while `use` runs; see `openPage`. */
export async function onPage(options, use) {
  const opened = await openPage(browser, site, options);
  try {
    await use({ ...opened, site });
  } catch (error) {
    // Shows what went wrong, in the folder of the pictures.
    await photograph(opened.page, `failed-${(failures += 1)}-${process.pid}`).catch(() => undefined);
    throw error;
  } finally {
    await opened.page.context().close();
  }
}
