// An assignment in a frame that fills another page.
import { PATIENCE } from './words.mjs';

/** The page in the frame, as the tests drive any page: elements are found in the frame, and fingers touch the page around it. */
export function framed(page, frame) {
  return {
    locator: (selector) => frame.locator(selector),
    waitForFunction: (...values) => frame.waitForFunction(...values),
    evaluate: (...values) => frame.evaluate(...values),
    waitForTimeout: (milliseconds) => page.waitForTimeout(milliseconds),
    viewportSize: () => page.viewportSize(),
    get mouse() {
      return page.mouse;
    },
    get keyboard() {
      return page.keyboard;
    },
    get touchscreen() {
      return page.touchscreen;
    },
  };
}

/** Waits for the app in the frame of `around`, which is `page` or a frame in it, and returns it as `framed` does. */
export async function appInFrame(page, around = page) {
  const handle = await around.waitForSelector('iframe');
  const frame = await handle.contentFrame();
  await frame.waitForFunction(() => globalThis.robotran !== undefined);
  await frame.waitForFunction(() => document.querySelector('#robotran-words [data-tag]'));
  return framed(page, frame);
}

/** The text of a page whose frame shows `address`. It keeps the messages from there, and answers the first one with `work`. */
export const pageAround = (address, work = '') => `<!DOCTYPE html>
<html lang="en"><head><title>Around</title><style>html, body, iframe { margin: 0; border: 0; width: 100%; height: 100%; display: block }</style></head>
<body><script>
  const messages = [];
  const work = ${JSON.stringify(work)};
  addEventListener('message', ({ data, origin, source }) => {
    messages.push({ ...data, origin });
    if (work && data.kind === 'ready') source.postMessage({ robotran: 1, kind: 'resume', work }, origin);
  });
</script><iframe title="Robotran" src="${address}"></iframe></body></html>`;

/** Waits for a message of `kind` to the page around for which `test` is true, and returns it. */
export async function message(page, kind, test = () => true) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const all = await page.evaluate(() => messages);
    const found = all.filter((each) => each.kind === kind).findLast(test);
    if (found) return found;
    if (Date.now() > end) throw new Error(`no ${kind} as expected in ${JSON.stringify(all)}`);
    await page.waitForTimeout(200);
  }
}
