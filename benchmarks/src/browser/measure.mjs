// Prints the benchmark results of the page PAGE in Chromium, one line per named benchmark; all if none is named.
import { startBrowser } from '../../../webApp/src/browserTest/browser.mjs';
import { serve } from '../../../webApp/src/browserTest/serve.mjs';

const wanted = process.argv.slice(2);
const browser = await startBrowser({ optimizing: true });
const site = await serve(process.env.PAGE);
try {
  const page = await browser.newPage();
  await page.goto(site.address);
  await page.waitForFunction(() => globalThis.benchmarks?.names !== undefined);
  const names = (await page.evaluate(() => globalThis.benchmarks.names)).split(',');
  for (const name of names.filter((one) => wanted.length === 0 || wanted.includes(one))) {
    console.log(await page.evaluate((one) => globalThis.benchmarks.measure(one), name));
  }
} finally {
  await browser.close();
  site.stop();
}
