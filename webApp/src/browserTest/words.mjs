// Finds and presses elements through the accessibility HTML above the page's canvas.
import assert from 'node:assert/strict';

/** How long anything may take on a machine that does much else, in milliseconds. What takes longer is broken. */
export const PATIENCE = 90_000;

/** The element with the app's test tag `tag`. */
export const words = (page, tag) => page.locator(`#robotran-words [data-tag="${tag}"]`);

/**
 * The centre `x`, `y` and the box of `tag` in CSS pixels, once it exists and stays still: for three frames for which the accessibility HTML is as new
 * as the screen, or for many if it never is, as during a run. Frames, not seconds, tell that the page had its time.
 */
export async function placeOf(page, tag) {
  const place = await page.evaluate(STANDS_STILL, [tag, PATIENCE]);
  assert.ok(place, `${tag} does not stand still`);
  return place;
}

/** Runs in the page: see `placeOf`. */
const STANDS_STILL = async ([tag, patience]) => {
  const end = performance.now() + patience;
  let [before, since, still, resting] = ['', 0, 0, 0];
  while (performance.now() < end) {
    const { left, top, width, height } =
      document.querySelector(`#robotran-words [data-tag="${tag}"]`)?.getBoundingClientRect() ?? { width: 0 };
    const now = [left, top, width, height].join();
    if (now !== before) since = performance.now();
    still = now === before ? still + 1 : 0;
    resting = document.getElementById('robotran-words')?.hasAttribute('data-due') === false ? Math.min(resting + 1, still) : 0;
    // A menu takes a moment to unfold, of which the HTML tells nothing.
    const isThere = width > 0 && performance.now() - since > 200;
    if (isThere && (resting >= 3 || still >= 15)) return { left, top, width, height, x: left + width / 2, y: top + height / 2 };
    before = now;
    await new Promise((resolve) => globalThis.requestAnimationFrame(resolve));
  }
  return null;
};

/** Whether `tag` is there, or is gone, within as many frames as nothing takes that has not missed a press. */
export const comes = (page, tag, isThere) =>
  page.evaluate(
    async ([wanted, there]) => {
      for (let frame = 0; frame < 80; frame++) {
        if ((document.querySelector(`#robotran-words [data-tag="${wanted}"]`) !== null) === there) return true;
        await new Promise((resolve) => globalThis.requestAnimationFrame(resolve));
      }
      return false;
    },
    [tag, isThere],
  );

/** `page.waitForFunction(test, argument)`, whose error says that the page was expected `to` do something. */
async function waitFor(page, to, test, argument) {
  try {
    return await page.waitForFunction(test, argument, { timeout: PATIENCE });
  } catch (error) {
    throw new Error(`waited for ${to}: ${error.message}`, { cause: error });
  }
}

/**
 * Clicks on `tag` with the mouse. First scrolls with the wheel if it is out of sight, such as at the end of a long
 * menu.
 */
export async function press(page, tag) {
  let { x, y } = await placeOf(page, tag);
  const { height } = page.viewportSize();
  if (y > height) {
    await page.mouse.move(x, height / 2);
    await page.mouse.wheel(0, y - height / 2);
    ({ x, y } = await placeOf(page, tag));
  }
  await page.mouse.click(x, y);
}

/** Taps `tag` in a page with touch. */
export async function tap(page, tag) {
  const { x, y } = await placeOf(page, tag);
  await page.touchscreen.tap(x, y);
}

/** Taps `tag` until `expected` is there: what has just opened or closed may miss a tap. */
export async function tapFor(page, tag, expected) {
  for (let attempt = 0; attempt < 4; attempt++) {
    await tap(page, tag);
    if (await comes(page, expected, true)) return;
    if ((await words(page, tag).count()) === 0) break; // The menu is gone, and what it opens takes its time.
  }
  await appears(page, expected);
}

/**
 * Presses `tag`, a tool of the program, by touch or mouse as `point` does. A row of tools without room for it has it in
 * its menu.
 */
export async function pointAtTool(page, tag, point) {
  await appears(page, 'editor-more');
  if ((await words(page, tag).count()) === 0) await point(page, 'editor-more');
  await point(page, tag);
}

/** Opens the menu `opener` and selects `item` in it. */
export async function choose(page, opener, item) {
  await press(page, opener);
  await select(page, item);
}

/** Selects `item` in an open menu. One that has just opened may miss a click. */
async function select(page, item) {
  await appears(page, item);
  for (let attempt = 0; attempt < 4 && (await words(page, item).count()) > 0; attempt++) {
    await press(page, item);
    if (await comes(page, item, false)) return;
  }
  await disappears(page, item);
}

/** Selects `item`, which is further down in the menu of the project: behind "Files and more". */
export async function chooseFile(page, item) {
  await choose(page, 'work-menu', 'work-more');
  await select(page, item);
}

/** Opens what is for teachers, and there presses `button`. */
export async function asTeacher(page, button) {
  await choose(page, 'menu', 'menu-teachers');
  await press(page, button);
  await disappears(page, 'teachers-page');
}

/** Waits until `tag` exists, or no longer exists. */
export const appears = (page, tag) => words(page, tag).first().waitFor({ state: 'attached', timeout: PATIENCE });
export const disappears = (page, tag) => words(page, tag).first().waitFor({ state: 'detached', timeout: PATIENCE });

/** Waits until the text of `tag` matches. */
export const says = (page, tag, pattern) =>
  waitFor(
    page,
    `${tag} to say ${pattern}`,
    ([wanted, source]) => {
      const element = document.querySelector(`#robotran-words [data-tag="${wanted}"]`);
      const text = element && (element.value ?? '') + element.textContent + (element.getAttribute('aria-label') ?? '');
      return text !== null && new RegExp(source, 's').test(text);
    },
    [tag, pattern.source],
  );

/** Waits until any text on the screen matches. */
export const isSaid = (page, pattern) =>
  page.locator('#robotran-words').getByText(pattern).first().waitFor({ state: 'attached', timeout: PATIENCE });

/** The text of the program's editor. */
export const programText = (page) =>
  page.evaluate(() => {
    const field = document.activeElement?.tagName === 'TEXTAREA' ? document.activeElement : null;
    return field?.value ?? document.querySelector('#robotran-words [data-tag="program"]')?.value;
  });

/** Clicks into the program, and waits until it has the focus. */
export async function enterProgram(page) {
  await press(page, 'program');
  await waitFor(page, 'the program to get the focus', () => document.activeElement?.tagName === 'TEXTAREA');
}

/** Clicks into the program and replaces it by `text`, key by key. */
export async function writeProgram(page, text) {
  await enterProgram(page);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  const lines = text.split('\n');
  for (const [number, line] of lines.entries()) {
    if (number > 0) await page.keyboard.press('Enter');
    await page.keyboard.type(line);
    // Close the completions, which would handle Enter. Without completions Escape does nothing.
    await page.keyboard.press('Escape');
  }
}

/** Waits until `test` returns true for the run's report. `test` runs outside the page, whose policy forbids `eval`. */
export async function reports(page, test) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const now = JSON.parse(await page.evaluate(() => globalThis.robotran.report()));
    if (test(now)) return;
    if (Date.now() > end) throw new Error(`${JSON.stringify(now)} is not as ${test} wants it`);
    await page.waitForTimeout(100);
  }
}
