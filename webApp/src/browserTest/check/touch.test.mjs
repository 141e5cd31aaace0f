// Multi-touch on the built page, and an on-screen keyboard.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photograph, report } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { appears, placeOf, press, reports, says, words, writeProgram } from '../words.mjs';

/**
 * Touch points: each call passes the current positions of all fingers. 'touchEnd' passes the fingers that lift; all if
 * none is passed.
 */
async function fingersOn(page) {
  const session = await page.context().newCDPSession(page);
  return (type, ...places) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: places.map((place, id) => ({ id, ...place })) });
}

test('two fingers hold two buttons of the brick', () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    await press(page, 'brick-size');
    await writeProgram(page, 'repeat 1000 times\nforward 1\nbackward 1\nend');
    await press(page, 'run');
    await reports(page, (report) => report.status === 'running');
    const touch = await fingersOn(page);
    const [run, onOff] = [await placeOf(page, 'brick-run'), await placeOf(page, 'brick-on_off')];
    await touch('touchStart', run);
    await touch('touchStart', run, onOff);
    await photograph(page, 'two-fingers');
    assert.equal((await report(page)).status, 'running', 'the program ends when On-Off is let go while Run is held');
    await touch('touchEnd', { ...onOff, id: 1 });
    await reports(page, (report) => report.status === 'ended');
    await touch('touchEnd');
    await says(page, 'lcd', /\d/);
    assert.deepEqual(troubles, []);
  }));

test('two fingers move the sheet apart, and a wheel with Ctrl does the same without zooming the page', () =>
  onPage({ ...TABLET, hasTouch: true }, async ({ page, troubles }) => {
    const touch = await fingersOn(page);
    const world = await placeOf(page, 'world');
    const width = () => words(page, 'thing-robot-0').evaluate((element) => element.getBoundingClientRect().width);
    await placeOf(page, 'thing-robot-0');
    const before = await width();
    const apart = (pixels) => [
      { x: world.x - pixels, y: world.y },
      { x: world.x + pixels, y: world.y },
    ];
    await touch('touchStart', apart(40)[0]);
    await touch('touchStart', ...apart(40));
    for (const pixels of [60, 80, 100, 120]) await touch('touchMove', ...apart(pixels));
    await touch('touchEnd');
    await page.waitForFunction(
      (least) => document.querySelector('[data-tag="thing-robot-0"]').getBoundingClientRect().width > least,
      before * 1.5,
    );
    await photograph(page, 'pinched');
    await page.mouse.move(world.x, world.y);
    await page.keyboard.down('Control');
    for (let step = 0; step < 12; step++) await page.mouse.wheel(0, 10);
    await page.keyboard.up('Control');
    await page.waitForFunction(
      (most) => document.querySelector('[data-tag="thing-robot-0"]').getBoundingClientRect().width < most,
      before * 1.5,
    );
    assert.equal(await page.evaluate(() => visualViewport.scale), 1);
    assert.deepEqual(troubles, []);
  }));

test('a keyboard on the screen leaves the line that is written in sight', () =>
  onPage({ ...PHONE, hasTouch: true, isMobile: true, prepare: screenKeyboard }, async ({ page, troubles }) => {
    await press(page, 'tab-program');
    await appears(page, 'program');
    const { x, y } = await placeOf(page, 'program');
    await page.touchscreen.tap(x, y);
    await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
    await page.keyboard.press('Control+End');
    await page.keyboard.insertText('beep\n'.repeat(30));
    await page.evaluate(() => globalThis.showKeyboard(360));
    await page.waitForFunction(() => document.querySelector('canvas').clientHeight < 600);
    const field = () => page.evaluate(() => document.activeElement.getBoundingClientRect().bottom);
    await page.keyboard.type('be');
    await page.waitForFunction(() => document.activeElement.getBoundingClientRect().bottom <= visualViewport.height);
    assert.ok((await field()) > 100);
    await photograph(page, 'phone-keyboard');
    await page.evaluate(() => globalThis.showKeyboard(0));
    await page.waitForFunction(() => document.querySelector('canvas').clientHeight > 800);
    assert.deepEqual(troubles, []);
  }));

/** Runs in the page: a fake visual viewport that an on-screen keyboard shrinks, which a headless browser lacks. */
function screenKeyboard() {
  const view = new EventTarget();
  let covered = 0;
  Object.defineProperties(view, {
    width: { get: () => innerWidth },
    height: { get: () => innerHeight - covered },
    offsetLeft: { value: 0 },
    offsetTop: { value: 0 },
    scale: { value: 1 },
  });
  Object.defineProperty(window, 'visualViewport', { value: view });
  globalThis.showKeyboard = (height) => {
    covered = height;
    view.dispatchEvent(new Event('resize'));
  };
}

test('a tablet with a keyboard on its screen stays arranged as it was', () =>
  onPage({ ...TABLET, hasTouch: true, prepare: screenKeyboard }, async ({ page, troubles }) => {
    const { x, y } = await placeOf(page, 'program');
    await page.touchscreen.tap(x, y);
    await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
    await page.evaluate(() => globalThis.showKeyboard(400));
    await page.waitForFunction(() => document.querySelector('canvas').clientHeight === 400);
    await page.keyboard.type('x');
    await photograph(page, 'tablet-keyboard');
    assert.equal(
      await page.evaluate(() => document.activeElement.tagName),
      'TEXTAREA',
      'the program is still being written in',
    );
    assert.ok((await report(page)).status);
    assert.deepEqual(troubles, []);
  }));
