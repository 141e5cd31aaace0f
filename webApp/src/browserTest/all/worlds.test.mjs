// Worlds that replace the current one: the pupil's changes are kept, and the new task is shown.
import assert from 'node:assert/strict';
import { isKept } from '../kept.mjs';
import { linkTo } from '../link.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, PHONE, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { appears, choose, chooseFile, disappears, press, reports, says, tap, words, writeProgram } from '../words.mjs';

const TASK = 'Drive to the flag in the upper corner.\nLift the pen on the way.\nBeep when you are there.';
const WORLD = {
  format: 'robotran-world',
  version: 2,
  title: 'The corner of Ms Weber',
  task: TASK,
  paper: { width: 80, height: 60 },
  robots: [{ start: { x: 20, y: 15, heading: 0 } }],
  goals: [{ kind: 'reach', region: { circle: { x: 60, y: 50, radius: 6 } } }],
};
const LINK = linkTo('w', WORLD);
const BARE_LINK = linkTo('w', { ...WORLD, robots: [{ ...WORLD.robots[0], ports: {} }] });

const LIGHT_ON_PORT_1 = `import josx.platform.rcx.*;

public class Program {
    public static void main(String[] args) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_LIGHT, SensorConstants.SENSOR_MODE_PCT);
        Sensor.S1.activate();
        Thread.sleep(20000);
    }
}
`;

const follow = (page, link) =>
  page.evaluate((fragment) => {
    location.hash = fragment;
  }, link);
const JAVA = 'public class Program {\n    public static void main(String[] args) {\n        int own = 77;\n    }\n}\n';

async function buildWorld(page) {
  await press(page, 'edit-world');
  await appears(page, 'edit-done');
  await press(page, 'palette-block');
  await isKept(page, '"blocks"');
  await press(page, 'edit-done');
  await appears(page, 'thing-block-0');
}

test("a world of one's own is kept when another is chosen, and a touch brings it back", () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'forward 11');
    await buildWorld(page);
    await press(page, 'worlds');
    await press(page, 'world-square');
    await says(page, 'notice-text', /kept in My work/);
    await disappears(page, 'thing-block-0');
    await says(page, 'task-title', /A square/);
    await says(page, 'program', /forward 11/);
    await photograph(page, 'world-chosen');
    await choose(page, 'work-menu', 'work-my-work');
    await page.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length === 2);
    await photograph(page, 'my-work-pictures');
    await press(page, 'document-cancel');
    await press(page, 'notice-action');
    await appears(page, 'thing-block-0');
    await says(page, 'program', /forward 11/);
    // The unchanged world is not in the list of projects.
    await choose(page, 'work-menu', 'work-my-work');
    await page.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length === 1);
    assert.deepEqual(troubles, []);
  }));

test('a Java program comes along into another world and stays in the work before', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await press(page, 'program');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(JAVA);
    await isKept(page, 'own = 77');
    await press(page, 'worlds');
    await press(page, 'world-square');
    await says(page, 'task-title', /A square/);
    await says(page, 'program', /own = 77/);
    await press(page, 'notice-action');
    await says(page, 'program', /own = 77/);
    assert.deepEqual(troubles, []);
  }));

test('a finger plugs in the sensor that a Java program looks for in a world from a link, and takes it out again', () =>
  onPage({ ...TABLET, hasTouch: true, address: LINK }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await press(page, 'program');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(LIGHT_ON_PORT_1);
    await tap(page, 'run');
    await appears(page, 'plug-in');
    await photograph(page, 'plug-in');
    await tap(page, 'plug-in');
    await says(page, 'notice-text', /Port 1 has the sensor now/);
    await photograph(page, 'plugged-in');
    await tap(page, 'notice-action');
    await tap(page, 'run');
    await appears(page, 'plug-in');
    await tap(page, 'plug-in');
    await disappears(page, 'plug-in');
    await tap(page, 'run');
    await reports(page, (report) => report.status === 'running' && report.seconds > 0.5);
    await reports(page, (report) => report.missingSensors === undefined);
    assert.deepEqual(troubles, []);
  }));

test('on a phone held across, in German, a finger plugs in all sensors that are missing at once, and takes them out', () =>
  onPage({ width: 891, height: 411, hasTouch: true, locale: 'de-DE', address: BARE_LINK }, async ({ page, troubles }) => {
    await tap(page, 'tab-program');
    await choose(page, 'view-switch', 'view-text');
    await tap(page, 'program');
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText('wait until left bumper or right bumper\nbeep\n');
    await tap(page, 'run');
    await tap(page, 'tab-program');
    await says(page, 'plug-in', /An den Anschlüssen 1 und 3 einstecken/);
    await photograph(page, 'plug-in-german');
    await tap(page, 'plug-in');
    await says(page, 'notice-text', /Die Sensoren sind jetzt an den Anschlüssen 1 und 3/);
    await photograph(page, 'plugged-in-german');
    await tap(page, 'notice-action');
    await disappears(page, 'notice-text');
    await tap(page, 'run');
    await tap(page, 'tab-program');
    await tap(page, 'plug-in');
    await tap(page, 'run');
    await reports(page, (report) => report.status === 'running' && report.missingSensors === undefined);
    assert.deepEqual(troubles, []);
  }));

test("a teacher's task is written in several lines, shared as a link, and read there", () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await press(page, 'edit-world');
    await appears(page, 'edit-done');
    await press(page, 'tab-edit-world');
    await press(page, 'field-task');
    await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
    await page.keyboard.press('Control+a');
    for (const [number, line] of ['Draw a house.', 'Then a door.'].entries()) {
      if (number > 0) await page.keyboard.press('Enter');
      await page.keyboard.type(line);
    }
    await photograph(page, 'task-field');
    await press(page, 'edit-done');
    await says(page, 'task-text', /Draw a house\.\nThen a door\./);
    await choose(page, 'work-menu', 'work-share-link');
    const link = new URL(await words(page, 'link-text').inputValue());
    await onPage({ ...PHONE, hasTouch: true, address: link.hash }, async ({ page: other }) => {
      await says(other, 'task-text', /Draw a house\.\nThen a door\./);
    });
    assert.deepEqual(troubles, []);
  }));

for (const [name, size] of [
  ['upright', PHONE],
  ['on its side', { width: 891, height: 411 }],
]) {
  test(`on a phone ${name} the task of a link is shown, goes with a touch and is one touch away`, () =>
    onPage({ ...size, hasTouch: true, address: LINK }, async ({ page, troubles }) => {
      await says(page, 'task-title', /Ms Weber/);
      await says(page, 'task-text', /upper corner\.\nLift the pen/);
      await appears(page, 'world');
      await photograph(page, `task-phone-${name.replaceAll(' ', '-')}`);
      await tap(page, 'task-hide');
      await disappears(page, 'task-text');
      await tap(page, 'task-chip');
      await appears(page, 'task-text');
      await tap(page, 'run');
      await disappears(page, 'task-text');
      await appears(page, 'task-title');
      assert.deepEqual(troubles, []);
    }));
}

test('the tutorial gives way to a world that comes by a link, and comes back with its step', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await press(page, 'learn');
    await press(page, 'try-step');
    await says(page, 'step-title', /A first drive/);
    await says(page, 'program', /forward 20/);
    await writeProgram(page, 'forward 31');
    await follow(page, LINK);
    await says(page, 'task-title', /Ms Weber/);
    await disappears(page, 'step-title');
    await photograph(page, 'tutorial-gave-way');
    await press(page, 'notice-action');
    await says(page, 'step-title', /A first drive/);
    await says(page, 'program', /forward 31/);
    assert.deepEqual(troubles, []);
  }));

test('a world file that is opened leaves the world before in My work', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await buildWorld(page);
    const chooser = page.waitForEvent('filechooser');
    await chooseFile(page, 'work-open');
    await (
      await chooser
    ).setFiles([
      { name: 'corner.world.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(WORLD)) },
    ]);
    await says(page, 'task-title', /Ms Weber/);
    await isKept(page, 'Ms Weber');
    await reload(page);
    await disappears(page, 'thing-block-0');
    await choose(page, 'work-menu', 'work-my-work');
    await page.waitForFunction(() => document.querySelectorAll('[data-tag^="work-w"]').length === 2);
    assert.deepEqual(troubles, []);
  }));
