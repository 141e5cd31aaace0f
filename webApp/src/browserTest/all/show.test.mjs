// What a pupil made is shown to others, by touch on a phone: as a moving picture, as a video, as a poster on paper.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
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
    await tap(page, 'show-make');
    await appears(page, 'show-made');
    await photograph(page, 'show-made');
    const { name, bytes } = await downloaded(page, () => tap(page, 'show-save'));
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

test('a video is filmed in the page', () =>
  onPage(FINGERS, async ({ page, troubles }) => {
    await drawAndShow(page);
    await tap(page, 'show-video');
    await tap(page, 'show-speed-4');
    await tap(page, 'show-make');
    await appears(page, 'show-made');
    const { name, bytes } = await downloaded(page, () => tap(page, 'show-save'));
    assert.match(name, /\.webm$/);
    // The app's own policy allows no videos.
    const player = await page.context().newPage();
    const { size, end } = await player.evaluate(async (base64) => {
      const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const video = document.createElement('video');
      video.muted = true;
      video.src = URL.createObjectURL(new Blob([data], { type: 'video/webm' }));
      await new Promise((resolve, reject) => {
        video.onloadedmetadata = resolve;
        video.onerror = () => reject(video.error);
      });
      await video.play();
      await new Promise((resolve) => (video.onended = resolve));
      return { size: [video.videoWidth, video.videoHeight], end: video.currentTime };
    }, bytes.toString('base64'));
    console.log(`${bytes.length} bytes, ${size} pixels, ${end} s`);
    assert.equal(Math.max(...size), 640);
    assert.ok(end > 1, `${end} s`);
    assert.deepEqual(troubles, []);
  }));

test('a poster with drawing and program is one page on paper', () =>
  onPage(FINGERS, async ({ page, troubles }) => {
    await drawAndShow(page);
    await tap(page, 'show-poster');
    await tap(page, 'poster-maker');
    await page.keyboard.type('Ada');
    await photograph(page, 'show-poster');
    await page.evaluate(() => {
      globalThis.print = () => (globalThis.hasPrinted = true);
    });
    await tap(page, 'show-make');
    await appears(page, 'show-made');
    await photograph(page, 'show-made-poster');
    await tap(page, 'show-print');
    await page.waitForFunction(() => globalThis.hasPrinted);
    const printed = await page.evaluate(() => document.getElementById('poster').textContent.replace(/\u00a0/g, ' '));
    for (const words of [/Ada/, /pen\s*down/, /forward\s*20/]) assert.match(printed, words);
    const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
    await writeFile(path.join(process.env.PICTURES, 'poster.pdf'), pdf);
    const text = pdf.toString('latin1');
    assert.equal(text.match(/\/Type\s*\/Page\b/g).length, 1, 'one page');
    assert.match(text, /\/MediaBox\s*\[0 0 59[45][\d.]* 84[12][\d.]*\]/, 'of A4, upright');
    const picture = await downloaded(page, () => tap(page, 'show-save'));
    assert.match(picture.name, /\.png$/);
    const sides = [16, 20].map((place) => picture.bytes.readUInt32BE(place));
    assert.deepEqual(sides, [1680, 2376], 'a picture of the whole page');
    await tap(page, 'show-more');
    await tap(page, 'show-poster');
    await tap(page, 'poster-kind-1');
    await tap(page, 'show-make');
    await appears(page, 'show-made');
    const { name, bytes } = await downloaded(page, () => tap(page, 'show-save'));
    assert.match(name, /\.svg$/);
    assert.match(bytes.toString(), /^<svg [^>]*viewBox="0 0 210 297"/);
    assert.deepEqual(troubles, []);
  }));
