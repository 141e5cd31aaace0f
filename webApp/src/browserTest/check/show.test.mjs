// What a pupil made is shown to others, by touch on a phone: as a video, as a poster on paper.
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { photograph } from '../page.mjs';
import { onPage } from '../set-up.mjs';
import { downloaded, drawAndShow, FINGERS } from '../show.mjs';
import { tap } from '../words.mjs';

test('a video is filmed in the page', () =>
  onPage(FINGERS, async ({ page, troubles }) => {
    await drawAndShow(page);
    await tap(page, 'show-video');
    await tap(page, 'show-speed-4');
    const { name, bytes } = await downloaded(page, () => tap(page, 'show-make'));
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
    await tap(page, 'poster-print');
    await page.waitForFunction(() => globalThis.hasPrinted);
    const printed = await page.evaluate(() => document.getElementById('poster').textContent.replace(/\u00a0/g, ' '));
    for (const words of [/Ada/, /pen down/, /forward 20/]) assert.match(printed, words);
    const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
    await writeFile(path.join(process.env.PICTURES, 'poster.pdf'), pdf);
    const text = pdf.toString('latin1');
    assert.equal(text.match(/\/Type\s*\/Page\b/g).length, 1, 'one page');
    assert.match(text, /\/MediaBox\s*\[0 0 59[45][\d.]* 84[12][\d.]*\]/, 'of A4, upright');
    const { name, bytes } = await downloaded(page, () => tap(page, 'poster-save'));
    assert.match(name, /\.svg$/);
    assert.match(bytes.toString(), /^<svg [^>]*viewBox="0 0 210 297"/);
    assert.deepEqual(troubles, []);
  }));
