// A headless Chromium, driven by Playwright. The build sets up both.
import { createRequire } from 'node:module';
import { look } from './page.mjs';

const { chromium } = createRequire(import.meta.url)('playwright-core');

const QUIET = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  // The later part of the page for tests is larger than that of the published page, see `parts.js`.
  '--enable-features=WebAssemblyUnlimitedSyncCompilation',
];

/** V8's quick compiler alone: its optimising one takes four seconds of a processor each time the page is opened. */
const QUICK = '--js-flags=--liftoff-only';

const launchOptions = (optimizing, args = []) => ({
  executablePath: process.env.CHROMIUM,
  args: optimizing ? [...QUIET, ...args] : [...QUIET, QUICK, ...args],
});

/** Starts the browser at the path CHROMIUM, with further `args`. With `optimizing` it compiles WebAssembly as for a pupil. */
export const startBrowser = ({ optimizing = false, args } = {}) => chromium.launch(launchOptions(optimizing, args));

/** Starts it with a profile folder that keeps stored data. Returns its only context. */
export const launchPerson = (folder, { optimizing = false, ...options } = {}) =>
  chromium.launchPersistentContext(folder, { ...launchOptions(optimizing), ...options });

/**
 * The centre of the largest area of one colour on the screen, such as a button on the canvas: { x, y, size } in CSS
 * pixels, or null.
 */
export async function findColour(page, [red, green, blue]) {
  const picture = (await look(page, () => page.screenshot())).toString('base64');
  return page.evaluate(
    async ([encoded, wanted]) => {
      const bytes = Uint8Array.from(atob(encoded), (character) => character.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const { width, height } = image;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      const matches = (place) => wanted.every((value, channel) => Math.abs(data[place * 4 + channel] - value) < 12);
      const seen = new Uint8Array(width * height);
      let best = null;
      for (let start = 0; start < seen.length; start++) {
        if (seen[start] || !matches(start)) continue;
        let count = 0,
          sumX = 0,
          sumY = 0;
        const waiting = [start];
        seen[start] = 1;
        while (waiting.length) {
          const place = waiting.pop(),
            x = place % width,
            y = (place - x) / width;
          count++;
          sumX += x;
          sumY += y;
          for (const next of [
            x > 0 && place - 1,
            x < width - 1 && place + 1,
            y > 0 && place - width,
            y < height - 1 && place + width,
          ]) {
            if (next !== false && !seen[next] && matches(next)) {
              seen[next] = 1;
              waiting.push(next);
            }
          }
        }
        if (best === null || count > best.size) best = { x: sumX / count, y: sumY / count, size: count };
      }
      return best && { x: best.x / devicePixelRatio, y: best.y / devicePixelRatio, size: best.size };
    },
    [picture, [red, green, blue]],
  );
}
