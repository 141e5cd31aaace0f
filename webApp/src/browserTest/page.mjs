// The built page as a test opens it.
import path from 'node:path';

/** The colour of Run on the brick. */
export const RUN_GREEN = [0x2e, 0x9e, 0x4f];

// Skiko of Compose 1.7.3 reaches its memory the way older Kotlin gave it out; it works, and newer ones mend it.
const KNOWN_COMPLAINT = /Accessing `memory` via `wasmExports` is deprecated/;

/**
 * Opens the page and waits until the workshop is there; what goes wrong in the page, or is fetched from elsewhere, is collected.
 * The function `prepare`, if there is one, runs in the page before anything else.
 */
export async function openPage(browser, site, { width, height, dark = false, prepare }) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? 'dark' : 'light' });
  const page = await context.newPage();
  if (prepare) await page.addInitScript(prepare);
  const troubles = [];
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && !KNOWN_COMPLAINT.test(message.text()) && troubles.push(message.text()));
  page.on('request', (request) => request.url().startsWith(site.address) || /^(data|blob):/.test(request.url()) || troubles.push(`fetched ${request.url()}`));
  await page.goto(site.address);
  await page.waitForFunction(() => globalThis.robotran !== undefined, null, { timeout: 60_000 });
  await page.waitForLoadState('networkidle'); // words and fonts come after the first picture
  await page.waitForTimeout(500);
  return { page, troubles };
}

/** The report of the workshop's run up to now. */
export const report = async (page) => JSON.parse(await page.evaluate(() => globalThis.robotran.report()));

export const photograph = (page, name) => page.screenshot({ path: path.join(process.env.PICTURES, `${name}.png`) });
