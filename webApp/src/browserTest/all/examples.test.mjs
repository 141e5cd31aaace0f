// The examples and their thumbnails on a tablet and a phone, in both programming languages.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, choose, disappears, placeOf, press, says } from '../words.mjs';

test('an example is found in the menu and opened', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await choose(page, 'menu', 'menu-examples');
    await appears(page, 'example-flower.robo');
    // The thumbnails are rendered in the background.
    await page.waitForTimeout(3_000);
    await photograph(page, 'examples');
    await press(page, 'example-flower.robo');
    await disappears(page, 'examples-page');
    await says(page, 'program', /six petals/);
    assert.deepEqual(troubles, []);
  }));

test('behind the plus, who works in Java finds the examples in Java first', () =>
  onPage({ ...PHONE, hasTouch: true }, async ({ page, troubles }) => {
    const touch = async (tag) => {
      const { x, y } = await placeOf(page, tag);
      await page.touchscreen.tap(x, y);
    };
    await touch('tab-program');
    await touch('add-program');
    await touch('new-java');
    await disappears(page, 'new-java');
    await touch('add-program');
    await touch('examples');
    await touch('example-Countdown.java');
    await says(page, 'program', /class Countdown/);
    assert.deepEqual(troubles, []);
  }));

test('the examples say in German and Spanish what they do', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    for (const [place, about] of [
      [3, /Zeichnet eine gestrichelte Linie/],
      [2, /Dibuja una línea/],
    ]) {
      await choose(page, 'menu', 'menu-settings');
      await press(page, `language-${place}`);
      await press(page, 'settings-close');
      await disappears(page, 'settings-close');
      await choose(page, 'menu', 'menu-examples');
      await says(page, 'example-dashed-line.robo', about);
      await page.waitForTimeout(2_000);
      await photograph(page, `examples-language-${place}`);
      await page.goBack();
      await disappears(page, 'examples-page');
    }
    assert.deepEqual(troubles, []);
  }));
