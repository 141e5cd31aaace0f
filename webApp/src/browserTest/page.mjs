// Opens the built page for a test.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { press, words } from './words.mjs';

/** The colour of Run on the brick. */
export const RUN_GREEN = [0x2e, 0x9e, 0x4f];

// Skiko of Compose 1.7.3 accesses the memory through a deprecated export. It works, and newer versions fix it.
const KNOWN_COMPLAINT = /Accessing `memory` via `wasmExports` is deprecated/;

/**
 * Opens the page and waits until the workshop is ready. `troubles` collects errors in the page and downloads from other
 * hosts, `fetched` the URLs of all downloads. The optional function `prepare` runs in the page before anything else. A
 * new context counts as a first visit; the welcome dialog is closed unless the test needs it (`welcome`). `address` is
 * appended to the page's URL. All other options go to the browser context, which caches nothing for offline use unless
 * `serviceWorkers` is 'allow'.
 */
export async function openPage(
  browser,
  site,
  { width, height, dark = false, prepare, welcome = false, address = '', ...more },
) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: dark ? 'dark' : 'light',
    serviceWorkers: 'block',
    ...more,
  });
  const page = await context.newPage();
  if (prepare) await page.addInitScript(prepare);
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
  await page.goto(site.address + address);
  await isReady(page);
  if (!welcome && (await words(page, 'first-run').count()) > 0) await putWelcomeAway(page);
  return { page, troubles, fetched };
}

/** Waits until the workshop exists and its accessibility nodes are there, which follow the first frame. */
export async function isReady(page) {
  await page.waitForFunction(() => globalThis.robotran !== undefined, null, { timeout: 60_000 });
  await page.waitForFunction(() => document.querySelector('#robotran-words [data-tag]'), null, { timeout: 60_000 });
  await page.waitForLoadState('networkidle');
}

export async function putWelcomeAway(page) {
  await press(page, 'first-run-close');
  await words(page, 'first-run').waitFor({ state: 'detached' });
}

/** The report of the workshop's run so far. */
export const report = async (page) => JSON.parse(await page.evaluate(() => globalThis.robotran.report()));

export const photograph = (page, name) => page.screenshot({ path: path.join(process.env.PICTURES, `${name}.png`) });

/** Runs the example FILE in the page and compares it with its record in the folder RUNS, bit for bit. */
export async function assertRecordedRun(page, file, runs) {
  const record = path.join(runs, path.parse(file).name);
  const program = await readFile(file, 'utf8');
  const run = await page.evaluate(
    ([text, name]) => globalThis.robotran.run(text, 60_000, name),
    [program, path.basename(file)],
  );
  // The trace hash in the report covers the whole ROM log. Only short logs are recorded as text, too.
  if (existsSync(`${record}.rom-log.txt`))
    assert.equal(run.romLog, await readFile(`${record}.rom-log.txt`, 'utf8'), file);
  assert.equal(`${run.report}\n`, await readFile(`${record}.report.json`, 'utf8'), file);
}
