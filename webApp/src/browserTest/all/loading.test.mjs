// The greeting, in all languages and with all that can be chosen.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { test } from '../tried-again.mjs';
import { appIsThere, choice, hold, isCarriedOut, visit } from '../visit.mjs';
import { appears, PATIENCE } from '../words.mjs';

/** Waits until a screen reader finds all `texts` in the app. */
const finds = (page, texts) =>
  page.waitForFunction(
    (wanted) => {
      const found = [...document.querySelectorAll('#robotran-words *')].map(
        (element) => (element.getAttribute('aria-label') ?? '') + element.textContent,
      );
      return wanted.every((text) => found.some((each) => each.includes(text)));
    },
    texts,
    { timeout: PATIENCE },
  );

test('the first visit is greeted before the app is there, in the words of its welcome page', async () => {
  for (const locale of ['en-GB', 'es-MX', 'de-AT']) {
    const { route, goOn } = hold();
    const page = await visit({ locale, route });
    await page.waitForSelector(choice('square'), { state: 'visible' });
    const offered = await page.locator('[data-wish]').allTextContents();
    const views = await page.locator('fieldset :is(legend, label)').allTextContents();
    const title = await page.textContent('#greeting-title');
    await photograph(page, `greeting-${locale}`);
    goOn();
    await appIsThere(page);
    assert.equal(offered.length, 3);
    assert.equal(views.length, 3);
    await finds(page, [title, ...offered, ...views]);
    await page.context().close();
  }
});

test('what else is chosen on the greeting is carried out when the app is there', async () => {
  await isCarriedOut('tutorial', (page) => appears(page, 'tutorial'));
  await isCarriedOut('worlds', (page) => appears(page, 'worlds-page'));
});

/** How the program of the tutorial is shown, which was begun on the greeting after what `choose` has done there. */
async function viewOfTutorial(options, choose) {
  const { route, goOn } = hold();
  const page = await visit({ route, ...options });
  await choose(page);
  await page.click(choice('tutorial'));
  goOn();
  await appIsThere(page);
  await appears(page, 'hint-wanted');
  await page.waitForFunction(() => document.querySelector('#robotran-words :is([data-tag="block-pane"], [data-tag="program"])'));
  const hasBlocks = await page.locator('#robotran-words [data-tag="block-pane"]').count();
  await page.context().close();
  return hasBlocks ? 'blocks' : 'text';
}

test('who starts from the greeting begins in blocks with a finger and in text with a keyboard, or as they chose', async () => {
  const viewport = { width: 1280, height: 800 };
  const finger = { viewport, hasTouch: true, isMobile: true };
  const nothing = async () => undefined;
  const view = (name) => (page) => page.check(`[name="view"][value="${name}"]`);
  assert.equal(await viewOfTutorial(finger, nothing), 'blocks');
  assert.equal(await viewOfTutorial({ viewport }, nothing), 'text');
  assert.equal(await viewOfTutorial(finger, view('text')), 'text');
  assert.equal(await viewOfTutorial({ viewport }, view('blocks')), 'blocks');
});
