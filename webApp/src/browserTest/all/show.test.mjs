// A run as a moving picture.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { downloaded, drawAndShow, FINGERS } from '../show.mjs';
import { test } from '../tried-again.mjs';
import { appears, disappears, says, tap } from '../words.mjs';

/** What the browser decodes: width, height, number of frames and seconds. */
const decodedGif = (page, bytes) =>
  page.evaluate(async (base64) => {
    const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const decoder = new ImageDecoder({ data, type: 'image/gif' });
    await decoder.tracks.ready;
    await decoder.completed;
    const { frameCount, repetitionCount } = decoder.tracks.selectedTrack;
    let microseconds = 0;
    let size;
    for (let frameIndex = 0; frameIndex < frameCount; frameIndex++) {
      const { image } = await decoder.decode({ frameIndex });
      microseconds += image.duration;
      size = [image.codedWidth, image.codedHeight];
      image.close();
    }
    return { size, frameCount, repetitionCount, seconds: microseconds / 1e6 };
  }, bytes.toString('base64'));

test('a run becomes a moving picture that plays everywhere', () =>
  onPage(FINGERS, async ({ page, troubles }) => {
    await drawAndShow(page);
    await photograph(page, 'show-choices');
    await tap(page, 'show-moving');
    await appears(page, 'show-make');
    await photograph(page, 'show-speed');
    const { name, bytes } = await downloaded(page, () => tap(page, 'show-make'));
    assert.match(name, /\.gif$/);
    const picture = await decodedGif(page, bytes);
    console.log(`${bytes.length} bytes, ${JSON.stringify(picture)}`);
    assert.equal(Math.max(...picture.size), 640);
    assert.ok(picture.frameCount > 30, `${picture.frameCount} frames`);
    assert.equal(picture.repetitionCount, Infinity);
    const run = JSON.parse(await page.evaluate(() => globalThis.robotran.report())).seconds;
    assert.ok(Math.abs(picture.seconds - 2 - run) < 0.2, `${picture.seconds} s of a run of ${run} s`);
    await says(page, 'show-saved', /\.gif/);
    await photograph(page, 'show-saved');
    await tap(page, 'show-close');
    await disappears(page, 'show-sheet');
    assert.deepEqual(troubles, []);
  }));

test('a moving picture can be cancelled while it is made', () =>
  onPage(FINGERS, async ({ page, troubles }) => {
    await drawAndShow(page);
    await tap(page, 'show-moving');
    await tap(page, 'show-make');
    await tap(page, 'show-cancel');
    await appears(page, 'show-moving');
    assert.deepEqual(troubles, []);
  }));
