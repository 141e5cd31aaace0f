// What a pupil made is shown to others, by touch on a phone.
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { PHONE } from './set-up.mjs';
import { appears, reports, tap } from './words.mjs';

export const FINGERS = { ...PHONE, hasTouch: true, acceptDownloads: true };

/** Runs the first program to its end, and opens the choice: two touches after the run, something is made. */
export async function drawAndShow(page) {
  await tap(page, 'run');
  await reports(page, (now) => now.status === 'ended');
  await tap(page, 'show');
  await appears(page, 'show-moving');
}

/** The bytes of the file that is downloaded while `act` runs. */
export async function downloaded(page, act) {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  const bytes = await readFile(await download.path());
  await writeFile(path.join(process.env.PICTURES, download.suggestedFilename()), bytes);
  return { name: download.suggestedFilename(), bytes };
}
