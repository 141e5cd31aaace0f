// All supported browsers that are installed.
import { startBrowser } from '../browser.mjs';
import { openFirefox } from './firefox.mjs';
import { openWebKit } from './webkit.mjs';

const { CHROMIUM, FIREFOX, WEBKIT, WEBKIT_DRIVER, ONLY_ENGINE } = process.env;

/**
 * By name, a function that opens a page with the API of `EnginePage`; null if the browser is missing, which the build
 * reports.
 */
export const ENGINES = Object.fromEntries(
  Object.entries({
    Chromium: CHROMIUM ? openChromium : null,
    Firefox: FIREFOX ? (size) => openFirefox(FIREFOX, size) : null,
    WebKit: WEBKIT ? (size) => openWebKit({ driver: WEBKIT_DRIVER, binary: WEBKIT }, size) : null,
  }).filter(([name]) => ONLY_ENGINE === undefined || ONLY_ENGINE === name),
);

async function openChromium({ width, height }) {
  const browser = await startBrowser({ optimizing: true });
  const context = await browser.newContext({ viewport: { width, height }, serviceWorkers: 'allow' });
  const page = await context.newPage();
  let crashed = false;
  page.on('crash', () => {
    crashed = true;
  });
  page.crashed = async () => crashed;
  page.close = () => browser.close();
  return page;
}
