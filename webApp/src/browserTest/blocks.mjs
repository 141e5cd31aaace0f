// Builds programs from blocks in the page. What a pupil does is passed as a `hand` that presses things by their tags: a
// finger, or a screen reader.
import assert from 'node:assert/strict';
import { appears, comes, disappears, PATIENCE, placeOf, words } from './words.mjs';

/**
 * Waits until the accessibility HTML has been as new as the screen for two whole frames, so that what was done last has been
 * drawn and told, or for some frames if the screen never rests.
 */
const rests = (page) =>
  page.evaluate(async () => {
    const isDue = () => document.getElementById('robotran-words').hasAttribute('data-due');
    for (let frame = 0, resting = 0; frame < 15 && resting < 3; frame++) {
      await new Promise((resolve) => globalThis.requestAnimationFrame(resolve));
      resting = isDue() ? 0 : resting + 1;
    }
  });

/** Presses with one finger, each thing as soon as it stays where it is. */
export function fingerOn(page) {
  /** The place of `tag` now; null if there is none. */
  const boxOf = (tag) =>
    page.evaluate((wanted) => {
      const box = document.querySelector(`#robotran-words [data-tag="${wanted}"]`)?.getBoundingClientRect();
      if (!box) return null;
      const { left, top, width, height } = box;
      return { left, top, width, height, x: left + width / 2, y: top + height / 2 };
    }, tag);
  const touch = async (type, place) => {
    const session = (page.robotranTouch ??= await page.context().newCDPSession(page));
    await session.send('Input.dispatchTouchEvent', { type, touchPoints: place ? [place] : [] });
  };
  /** Moves the finger from one place to another, slowly enough that it does not fling. */
  const drag = async (from, to, { rest = 0, steps = 4 } = {}) => {
    await touch('touchStart', from);
    await page.waitForTimeout(rest);
    for (let step = 1; step <= steps; step++) {
      const part = step / steps;
      await touch('touchMove', { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part });
      await page.waitForTimeout(16);
    }
    // A finger that rests before it goes up flings nothing.
    await page.waitForTimeout(100);
    await touch('touchMove', to);
    await touch('touchEnd');
  };
  /** A place on the block `tag` without socket or button, behind the dots by which it is carried. */
  const bareOf = (tag) =>
    page.evaluate((wanted) => {
      const boxOf = (element) => element.getBoundingClientRect();
      const { left, top, right, bottom } = boxOf(document.querySelector(`#robotran-words [data-tag="${wanted}"]`));
      const taken = [...document.querySelectorAll('#robotran-words [data-tag]')]
        .filter((element) => /^(socket-|fold-|block-more)/.test(element.dataset.tag))
        .map(boxOf);
      for (let y = top + 24; y < bottom; y += 24) {
        for (let x = left + 36; x < right; x += 4) {
          const isTaken = taken.some((box) => x > box.left - 6 && x < box.right + 6 && y > box.top && y < box.bottom);
          if (!isTaken) return { x, y };
        }
      }
      return { x: left + 36, y: top + 24 };
    }, tag);
  /** A place on the value `tag` without another socket in it; its middle if it has none. */
  const bareOfValue = (tag, { x, y }) =>
    page.evaluate(
      ([wanted, middle]) => {
        const boxOf = (element) => element.getBoundingClientRect();
        const own = boxOf(document.querySelector(`#robotran-words [data-tag="${wanted}"]`));
        const inner = [...document.querySelectorAll('#robotran-words [data-tag^="socket-"]')]
          .filter((element) => element.dataset.tag !== wanted)
          .map(boxOf)
          .filter((box) => box.left >= own.left && box.right <= own.right && box.top >= own.top && box.bottom <= own.bottom);
        if (inner.length === 0) return middle;
        for (let place = own.right - 16; place > own.left; place -= 4) {
          if (!inner.some((box) => place > box.left - 8 && place < box.right + 8)) return { x: place, y: middle.y };
        }
        return middle;
      },
      [tag, { x, y }],
    );
  /** What can be seen of the sheet that `tag` is in, or of the page. */
  const viewOf = async (tag) => {
    const isInSheet = /^(group|take|digit|number|choice|value|name|form|action|palette|new-name|item)-/.test(tag);
    const sheet = isInSheet && (await boxOf('block-sheet'));
    if (sheet) return sheet;
    const { width, height } = page.viewportSize();
    return { left: 0, top: 0, width, height, x: width / 2, y: height / 2 };
  };
  /** Swipes over the list that has `tag`, which is not there before it can be seen: down, and then up again. */
  const find = async (tag) => {
    for (let attempt = 0; attempt < 24 && (await words(page, tag).count()) === 0; attempt++) {
      await rests(page);
      if (attempt < 2) continue;
      const { x, top, height } = await viewOf(tag);
      const [low, middle] = [top + height - 40, top + height * 0.5];
      if (attempt < 13) await drag({ x, y: low }, { x, y: middle });
      else await drag({ x, y: middle }, { x, y: low });
    }
  };
  /** Brings `tag` into sight by swiping over what it is in, and returns its place. */
  const bringIntoSight = async (tag) => {
    if (/^(take|world)-/.test(tag)) await find(tag);
    for (let attempt = 0; attempt < 8; attempt++) {
      const place = await placeOf(page, tag);
      const list = /^socket-/.test(tag) && (await boxOf('blocks'));
      if (list && place.top < list.top) {
        // It is above what can be seen of the list.
        const to = { x: list.x, y: list.top + list.height - 20 };
        await drag({ x: to.x, y: to.y - list.height * 0.25 }, to);
        continue;
      }
      const view = await viewOf(tag);
      const below = place.top + place.height - (view.top + view.height);
      const beyond = place.left + place.width - (view.left + view.width);
      if (below <= 0 && beyond <= 0) return place;
      const by = { x: beyond > 0 ? Math.min(beyond + 60, view.width - 80) : 0, y: 0 };
      if (beyond <= 0) by.y = Math.min(below + 40, view.height - 120);
      const from = beyond > 0 ? { x: view.left + view.width - 20, y: place.y } : { x: view.x, y: view.top + view.height - 20 };
      await drag(from, { x: from.x - by.x, y: from.y - by.y });
    }
    throw new Error(`${tag} cannot be brought into sight`);
  };
  return {
    async press(tag) {
      const middle = await bringIntoSight(tag);
      const { x, y } = /^block-\d/.test(tag)
        ? await bareOf(tag)
        : /^socket-/.test(tag)
          ? await bareOfValue(tag, middle)
          : middle;
      await page.touchscreen.tap(x, y);
    },
    placeOf: (tag) => placeOf(page, tag),
    drag,
  };
}

/** Presses the nodes of the accessibility tree, as a screen reader does. */
export const readerOn = (page) => {
  // In one step: the HTML may change between finding and pressing.
  const pressNow = (tag) =>
    page.evaluate((wanted) => {
      const element = document.querySelector(`#robotran-words [data-tag="${wanted}"]`);
      element?.click();
      return Boolean(element);
    }, tag);
  /** A list tells only what can be seen, and has actions that scroll: presses that of the list on top, if it has it. */
  const scrolls = (way) =>
    page.evaluate((wanted) => {
      const actions = [...document.querySelectorAll('#robotran-words button')].filter(({ textContent }) =>
        /^(Further down|Back up)/.test(textContent),
      );
      const listOf = ({ id }) => id.replace(/-\d+$/, '');
      const top = actions.at(-1);
      const action = actions.find((each) => listOf(each) === listOf(top) && each.textContent.startsWith(wanted));
      action?.click();
      return Boolean(action);
    }, way);
  /** All that is told now. */
  const seen = () =>
    page.evaluate(() => [...document.querySelectorAll('#robotran-words [data-tag]')].map(({ dataset }) => dataset.tag).join());
  return {
    async press(tag) {
      // It may be in a list that was scrolled past it before it came.
      let way = 'Further down';
      const end = Date.now() + PATIENCE;
      for (let attempt = 0; !(await pressNow(tag)); attempt++) {
        assert.ok(Date.now() < end, `${tag} is not among ${await seen()}`);
        await rests(page);
        if (attempt < 2 || (await words(page, tag).count()) > 0) continue;
        const before = await seen();
        if (!(await scrolls(way))) way = way === 'Back up' ? 'Further down' : 'Back up';
        else for (let wait = 0; wait < 20 && (await seen()) === before; wait++) await page.waitForTimeout(25);
      }
    },
  };
};

/** All blocks on the screen in order: { tag, words, sockets: [{ tag, words }] }. */
export const blocksOn = (page) =>
  page.evaluate(() => {
    const blocks = [];
    for (const element of document.querySelectorAll('#robotran-words [data-tag]')) {
      const { tag } = element.dataset;
      const words = element.getAttribute('aria-label') ?? '';
      if (/^block-\d/.test(tag)) blocks.push({ tag, words, sockets: [] });
      if (/^socket-/.test(tag)) blocks.at(-1)?.sockets.push({ tag, words });
    }
    return blocks;
  });

/** Waits until a block says `pattern`, and returns it: the one behind `skip` others. */
export async function blockSaying(page, pattern, skip = 0) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const all = await blocksOn(page);
    const found = all.filter((block) => pattern.test(block.words))[skip];
    if (found) return found;
    assert.ok(Date.now() < end, `No block says ${pattern}: ${all.map((block) => block.words).join(' | ')}`);
    await page.waitForTimeout(50);
  }
}

/** Waits until the blocks are those of `wanted`: the beginning of what each of them says. */
export async function areBlocks(page, wanted) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const all = (await blocksOn(page)).map((block) => block.words);
    if (all.length === wanted.length && all.every((words, place) => words.startsWith(wanted[place]))) return;
    assert.ok(Date.now() < end, `${all.join(' | ')} instead of ${wanted.join(' | ')}`);
    await page.waitForTimeout(50);
  }
}

/** What a hand builds: adds blocks, and changes what is in their sockets. */
export function builderWith(page, hand) {
  /** Waits until the sheet is closed, and the places of the blocks are those after the edit. */
  const isClosed = async () => {
    await disappears(page, 'block-sheet');
    await rests(page);
  };
  const closeSheet = async () => {
    await hand.press('block-sheet-close');
    await isClosed();
  };
  const placeOfSocket = async (block, socket, skip, place) => {
    const end = Date.now() + PATIENCE;
    for (;;) {
      // What was chosen before may not be there yet.
      const { sockets } = await blockSaying(page, block, skip);
      const found = sockets.filter(({ words }) => socket.test(words))[place];
      if (found) return found;
      assert.ok(Date.now() < end, `${block} has no ${socket}, only ${JSON.stringify(sockets)}`);
      await page.waitForTimeout(50);
    }
  };
  const openSocket = async (block, socket, skip, place = 0) => {
    for (let attempt = 0; attempt < 3; attempt++) {
      await hand.press((await placeOfSocket(block, socket, skip, place)).tag);
      if (await comes(page, 'block-sheet', true)) return; // What has just moved may miss a press.
    }
    await appears(page, 'block-sheet');
  };
  /** Types the number on the pad that is open, and closes it. */
  const typeNumber = async (number) => {
    for (const digit of `${number}`.replace('-', '')) await hand.press(`digit-${digit}`);
    if (number < 0) await hand.press('digit--');
    await closeSheet();
  };
  return {
    /** Puts the cursor at the block that says `pattern`. */
    async goTo(pattern, skip = 0) {
      await hand.press((await blockSaying(page, pattern, skip)).tag);
    },
    /** Adds blocks of the palette below the cursor: `groups` has the blocks of each group. */
    async add(...groups) {
      for (const [group, ...blocks] of groups) {
        let isOpen = false;
        for (const block of blocks) {
          if (!isOpen) {
            if ((await words(page, 'blocks-add').count()) > 0) await hand.press('blocks-add');
            await hand.press(`group-${group}`);
          }
          await hand.press(`take-${block}`);
          await rests(page);
          // Beside the blocks it stays open.
          isOpen = (await words(page, 'block-sheet').count()) > 0;
        }
      }
      if ((await words(page, 'block-sheet').count()) > 0) await closeSheet();
    },
    /** Replaces the number that says `socket` in the block that says `block`. */
    async setNumber(block, socket, number, skip = 0) {
      await openSocket(block, socket, skip);
      await typeNumber(number);
    },
    openSocket,
    typeNumber,
    /** Makes another choice: the button that says `choice`. If several sockets say `socket`, it is the one at `place`. */
    async choose(block, socket, choice, skip = 0, place = 0) {
      await openSocket(block, socket, skip, place);
      const tag = await tagOf(page, choice);
      await hand.press(tag);
      if (/^(choice|value|name)-/.test(tag)) await isClosed();
      else await closeSheet();
    },
    /** Chooses in the menu of the block that says `block` what says `action`. */
    async act(block, action, skip = 0) {
      await hand.press((await blockSaying(page, block, skip)).tag);
      await hand.press('block-more');
      await appears(page, 'block-sheet');
      await hand.press('actions-more');
      await hand.press(await tagOf(page, action));
    },
    closeSheet,
  };
}

/** Waits for a button of the open sheet that says `pattern`, and returns its tag. */
async function tagOf(page, pattern) {
  const found = await page.waitForFunction(
    (source) =>
      [...document.querySelectorAll('#robotran-words button[data-tag]')].find(
        (button) =>
          /^(choice|value|name|form|action|tone)-/.test(button.dataset.tag) &&
          new RegExp(source).test(button.getAttribute('aria-label')),
      )?.dataset.tag,
    pattern.source,
    { timeout: PATIENCE },
  );
  return found.jsonValue();
}

/** Runs in the page: what a screen reader is told to have the focus. */
const FOCUSED = () => {
  const id = document.querySelector('canvas').getAttribute('aria-activedescendant') ?? '';
  const element = document.getElementById(id);
  return { id, tag: element?.dataset.tag ?? '', words: element?.getAttribute('aria-label') ?? '' };
};

/** What keys alone do to blocks. */
export function keysOn(page) {
  const press = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
  };
  /** What a screen reader is told to have the focus: { id, tag, words }, all empty if nothing has. */
  const focused = () => page.evaluate(FOCUSED);
  /** Waits until what has the focus has another tag than `before`, or another id; a key may change nothing. */
  const moves = ({ id, tag }) =>
    page.evaluate(
      async ([lastId, lastTag]) => {
        for (let frame = 0; frame < 20; frame++) {
          const now = document.querySelector('canvas').getAttribute('aria-activedescendant') ?? '';
          if (now !== lastId || (document.getElementById(now)?.dataset.tag ?? '') !== lastTag) return;
          await new Promise((resolve) => globalThis.requestAnimationFrame(resolve));
        }
      },
      [id, tag],
    );
  /** Waits until the tag of what has the focus fits `pattern`. */
  const isAt = (pattern) =>
    page.waitForFunction(
      (source) => {
        const now = document.querySelector('canvas').getAttribute('aria-activedescendant') ?? '';
        return new RegExp(source).test(document.getElementById(now)?.dataset.tag ?? '');
      },
      pattern.source,
      { timeout: PATIENCE },
    );
  /** Presses `key` until what has the focus is `wanted`, as `isThere` says. */
  const pressUntil = async (wanted, isThere, key, most) => {
    await rests(page);
    for (let step = 0; step < most; step++) {
      const before = await focused();
      if (isThere(before)) return;
      await page.keyboard.press(key);
      await moves(before);
    }
    assert.fail(`${wanted} is not reached with ${key}, but ${JSON.stringify(await focused())}`);
  };
  /** Presses `key` until `tag` has the focus. */
  const goTo = (tag, key = 'Tab') => pressUntil(tag, (now) => now.tag === tag, key, 60);
  /** Goes right in the line until the part that says `pattern` has the cursor. */
  const goToPart = (pattern) => pressUntil(pattern, (now) => pattern.test(now.words), 'ArrowRight', 12);
  /** Waits until the sheet is closed and the blocks have the focus again. */
  const isBack = async () => {
    await disappears(page, 'block-sheet');
    await isAt(/^(block|socket)-/);
  };
  /** Opens a sheet with `key`, and waits until it has the focus. */
  const open = async (key) => {
    await press(key);
    await appears(page, 'block-sheet');
    await isAt(/^(?!block-|socket-)./);
  };
  const number = async (digits) => {
    await open('Enter');
    await press(...`${digits}`.replace('-', '').split(''));
    if (digits < 0) await press('-');
    await press('Enter');
    await isBack();
  };
  return {
    press,
    goTo,
    goToPart,
    /** Changes the number that is `right` steps into the line. */
    async setNumber(right, digits) {
      await press(...Array(right).fill('ArrowRight'));
      await number(digits);
    },
    isBack,
    open,
    /** Adds below the cursor the first block that is found for `query`. */
    async add(query) {
      await press('/');
      await appears(page, 'palette-search');
      await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
      await page.keyboard.type(query);
      await press('Enter');
      await isBack();
    },
    /** Makes the choice at the cursor that says `choice`. */
    async choose(choice) {
      await open('Enter');
      const tag = await tagOf(page, choice);
      await goTo(tag);
      await press('Enter');
      await isBack();
    },
  };
}
