// What Chromium's accessibility tree contains for the built page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { report } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { appears, PATIENCE, press, reports, says, words } from '../words.mjs';

/** All nodes of the accessibility tree: { role, name, value, live, disabled }. */
async function told(page) {
  const session = await page.context().newCDPSession(page);
  const { nodes } = await session.send('Accessibility.getFullAXTree');
  const property = (node, name) => node.properties?.find((found) => found.name === name)?.value?.value;
  return nodes
    .filter((node) => !node.ignored)
    .map((node) => ({
      role: node.role?.value,
      name: node.name?.value ?? '',
      value: node.value?.value ?? '',
      live: property(node, 'live'),
      disabled: property(node, 'disabled') === true,
    }));
}

test('buttons of the brick, its display, the program, and all that runs it are there for screen readers', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await press(page, 'brick-size');
    await appears(page, 'brick-view');
    let tree = [];
    const has = (role, name) => tree.some((node) => node.role === role && name.test(node.name));
    // The browser's tree follows the HTML with a delay.
    for (const end = Date.now() + PATIENCE; Date.now() < end && !has('button', /^View$/);) tree = await told(page);
    for (const name of [/^View$/, /^Prgm$/, /^On-Off$/, /^Run$/, /^Stop$/, /^Pause$/, /menu/i])
      assert.ok(has('button', name), `button ${name}`);
    const program = tree.find((node) => node.role === 'textbox');
    assert.match(program.value, /repeat 4 times/);
    assert.match(program.name, /./);
    assert.ok(
      tree.some((node) => node.live === 'polite' && /display/i.test(node.name + node.value)) ||
        (await words(page, 'lcd').count()) === 1,
      'the display',
    );
    assert.equal(await words(page, 'lcd').getAttribute('aria-live'), 'polite');
    assert.equal(await words(page, 'status').getAttribute('aria-live'), 'polite');
    assert.ok(
      tree.some((node) => /centimetres|cm/.test(node.name)),
      'where the robot is',
    );
    assert.deepEqual(troubles, []);
  }));

test('a screen reader presses Run on the brick, hears of the end, and stops with the bar', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await appears(page, 'brick-run');
    await words(page, 'brick-run').evaluate((button) => button.click());
    await reports(page, (report) => report.inkCentimetres > 5);
    await words(page, 'stop').evaluate((button) => button.click());
    await reports(page, (report) => report.status === 'ended');
    await says(page, 'announcer', /\d/);
    await says(page, 'status', /topped/);
    assert.ok((await report(page)).inkCentimetres < 79);
    assert.deepEqual(troubles, []);
  }));

test('the program is read and written as a text field', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await appears(page, 'program');
    await words(page, 'program').evaluate((field) => field.focus());
    await page.waitForFunction(
      () => document.activeElement?.tagName === 'TEXTAREA' && !document.activeElement.dataset.tag,
    );
    await page.waitForFunction(() => (document.activeElement.getAttribute('aria-label') ?? '') !== '');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText('beep');
    await page.waitForFunction(() => document.activeElement.value === 'beep');
    await reports(page, (report) => report.romCalls !== undefined);
    assert.deepEqual(troubles, []);
  }));

test('a dialog is alone while it is open', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await appears(page, 'run-more');
    await words(page, 'run-more').evaluate((button) => button.click());
    await appears(page, 'run-panel-close');
    assert.equal(await words(page, 'brick-run').count(), 0);
    await words(page, 'run-panel-close').evaluate((button) => button.click());
    await appears(page, 'brick-run');
    assert.deepEqual(troubles, []);
  }));
