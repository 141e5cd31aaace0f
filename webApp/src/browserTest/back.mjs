// Going back in the history of the browser.
import assert from 'node:assert/strict';
import { disappears, tapFor } from './words.mjs';

export const TABLET = { width: 1180, height: 820, hasTouch: true };
export const PHONE = { width: 412, height: 915, hasTouch: true };

/** The number of history entries above the page's own entry, once it is stable. */
export async function entries(page) {
  let last = null;
  for (let since = Date.now(); Date.now() - since < 900;) {
    const now = await page.evaluate(() => history.state?.robotran ?? 0);
    if (now !== last) since = Date.now();
    last = now;
    await page.waitForTimeout(60);
  }
  return last;
}

/** Opens `opened` by tapping the tags `steps` in order, and closes it by Back. */
export async function openAndGoBack(page, steps, opened) {
  const [first, item] = steps;
  await tapFor(page, first, item ?? opened);
  if (item) await tapFor(page, item, opened);
  assert.ok((await entries(page)) > 0, `${opened} has an entry`);
  await page.goBack();
  await disappears(page, opened);
  assert.equal(await entries(page), 0, `nothing is left of ${opened}`);
}
