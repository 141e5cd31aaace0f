// A teacher scans QR codes of programs with the camera: a film of six seconds takes as long as it takes.
import assert from 'node:assert/strict';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { startBrowser } from '../browser.mjs';
import { cameraOf, film } from '../camera.mjs';
import { look, openPage, photograph } from '../page.mjs';
import { openHandIns, scanner } from '../scan.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { choose, disappears, PATIENCE, placeOf, press, words, writeProgram } from '../words.mjs';

/** A picture of the QR code of a link to `program`. */
async function codeOf(page, program) {
  await writeProgram(page, program);
  await choose(page, 'work-menu', 'work-share-link');
  // The dialog may be too long for the screen: as large as the screen, no part of the code is cut off.
  await press(page, 'qr-code');
  await placeOf(page, 'qr-code-large');
  const { x, y, width, height } = await words(page, 'qr-code-large').boundingBox();
  const picture = await look(page, () => page.screenshot({ clip: { x, y, width, height } }));
  for (const open of ['qr-code-large', 'qr-code']) {
    await page.keyboard.press('Escape');
    await disappears(page, open);
  }
  return picture;
}

/** Runs in the page: keeps the streams of the camera for the test. */
function keepStreams() {
  globalThis.streams = [];
  const get = navigator.mediaDevices.getUserMedia.bind(navigator.mediaDevices);
  navigator.mediaDevices.getUserMedia = async (wanted) => {
    const stream = await get(wanted);
    globalThis.streams.push(stream);
    return stream;
  };
}

/** Waits until the camera has shown its film of six seconds once more, and the scanner has looked at all of it. */
const seesAgain = (page) =>
  page.evaluate(async () => {
    const video = document.querySelector('dialog.robotran-scanner video');
    const { getImageData } = CanvasRenderingContext2D.prototype;
    const begin = video.currentTime;
    await new Promise((resolve) => {
      let count = 0;
      CanvasRenderingContext2D.prototype.getImageData = function (...values) {
        count += 1;
        if (count >= 20 && video.currentTime - begin > 6.5) resolve();
        return getImageData.apply(this, values);
      };
    });
  });

test('codes before the camera become hand-ins, each once, and then the camera is off', () =>
  onPage(TABLET, async ({ page: pupil, site }) => {
    const folder = await mkdtemp(path.join(tmpdir(), 'robotran-'));
    const file = path.join(folder, 'codes.y4m');
    await film(pupil, [await codeOf(pupil, 'pen down\nforward 45'), await codeOf(pupil, 'forward 5')], file);
    const browser = await startBrowser({ args: cameraOf(file) });
    try {
      const options = { ...TABLET, permissions: ['camera'], prepare: keepStreams };
      const { page, troubles, fetched } = await openPage(browser, site, options);
      await openHandIns(page);
      const isLoaded = () => fetched.some((address) => address.includes('qr-scanner'));
      assert.ok(!isLoaded(), 'the scanner is loaded before it is needed');
      await press(page, 'hand-ins-scan');
      await scanner(page).getByRole('status').filter({ hasText: 'Codes read: 2' }).waitFor({ timeout: PATIENCE });
      assert.ok(isLoaded());
      await seesAgain(page);
      assert.equal(await scanner(page).getByRole('status').textContent(), 'Codes read: 2');
      assert.equal(await page.getByRole('dialog', { name: 'Scan QR codes' }).count(), 1);
      assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Done');
      await photograph(page, 'scanner');
      await page.keyboard.press('Enter');
      await scanner(page).waitFor({ state: 'detached' });
      assert.deepEqual(await page.evaluate(() => globalThis.streams.map((stream) => stream.active)), [false]);
      await page.waitForFunction(() => /1\s*Solved.*1\s*Not solved/s.test(document.body.textContent));
      await photograph(page, 'scanned');
      assert.deepEqual(troubles, []);
    } finally {
      await browser.close();
      await rm(folder, { recursive: true });
    }
  }));
