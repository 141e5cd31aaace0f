// Prints what the page PAGE measures in Chromium, a line for each of its benchmarks.
import { startBrowser } from '../../../webApp/src/browserTest/browser.mjs';
import { serve } from '../../../webApp/src/browserTest/serve.mjs';

const browser = await startBrowser();
const site = await serve(process.env.PAGE);
try {
  const page = await browser.newPage();
  await page.goto(site.address);
  await page.waitForFunction(() => globalThis.benchmarks !== undefined);
  for (const name of (await page.evaluate(() => globalThis.benchmarks.names)).split(',')) {
    console.log(await page.evaluate((wanted) => globalThis.benchmarks.measure(wanted), name));
  }
} finally {
  await browser.close();
  site.stop();
}
