// Going back in the history of the browser.
import assert from 'node:assert/strict';
import { disappears, PATIENCE, tapFor } from './words.mjs';

export const TABLET = { width: 1180, height: 820, hasTouch: true };
export const PHONE = { width: 412, height: 915, hasTouch: true };

/** Waits until there are `count` entries in the history above the page's own, and are still after some frames. */
export async function hasEntries(page, count) {
  const last = await page.evaluate(
    async ([wanted, patience]) => {
      const end = performance.now() + patience;
      const now = () => history.state?.robotran ?? 0;
      for (let frames = 0; frames < 15 && performance.now() < end; frames = now() === wanted ? frames + 1 : 0) {
        await new Promise((resolve) => globalThis.requestAnimationFrame(resolve));
      }
      return now();
    },
    [count, PATIENCE],
  );
  assert.equal(last, count, 'entries in the history');
}

/** Opens `opened` by tapping the tags `steps` in order, and closes it by Back. */
export async function openAndGoBack(page, steps, opened) {
  const [first, item] = steps;
  await tapFor(page, first, item ?? opened);
  if (item) await tapFor(page, item, opened);
  await hasEntries(page, 1);
  await page.goBack();
  await disappears(page, opened);
  await hasEntries(page, 0);
}
