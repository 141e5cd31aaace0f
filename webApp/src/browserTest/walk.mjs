// A walk through every screen and menu entry of the built page, by hand: `node walk.mjs [WIDTHxHEIGHT] [robolang|java]
// [max presses]`, with the environment of the browser tests. Starts with a new profile, taps each control once and
// saves a screenshot after each tap (PICTURES). Reports taps that changed neither the screenshot nor the accessibility
// nodes.
import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { startBrowser } from './browser.mjs';
import { loadAgain, openPage } from './page.mjs';
import { serve } from './serve.mjs';
import { choose } from './words.mjs';

const [size = '1180x820', language = 'robolang', most = '400'] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number);
const folder = path.join(process.env.PICTURES, `${size}-${language}`);

/** The max depth of nested menus and pages. */
const DEEPEST = 4;
const SETTLING = 900;

/** Runs in the page: all controls that can be pressed now, and all texts. */
function look() {
  const all = [...document.querySelectorAll('#robotran-words [data-tag]')];
  const pressable = all.filter(
    (element) =>
      (element.tagName === 'BUTTON' ||
        ['button', 'tab', 'switch', 'checkbox', 'radio', 'menuitem'].includes(element.getAttribute('role'))) &&
      element.getAttribute('aria-disabled') !== 'true' &&
      !element.disabled,
  );
  const inSight = ({ left, top, width: wide, height: high }) =>
    wide > 0 &&
    high > 0 &&
    left + wide / 2 > 0 &&
    left + wide / 2 < innerWidth &&
    top + high / 2 > 0 &&
    top + high / 2 < innerHeight;
  const things = pressable
    .map((element) => {
      const box = element.getBoundingClientRect();
      return { tag: element.dataset.tag, x: box.left + box.width / 2, y: box.top + box.height / 2, seen: inSight(box) };
    })
    .filter(({ seen }) => seen);
  const root = document.getElementById('robotran-words');
  const states = all.map(
    (element) =>
      `${element.dataset.tag} ${element.getAttribute('aria-checked')} ${element.getAttribute('aria-selected')} ${element.value ?? ''}`,
  );
  return { things, words: `${root.textContent}\n${states.join('\n')}` };
}

/** Of similar controls, such as examples and projects, only one of each kind is pressed. */
const kindOf = (tag) =>
  tag.replace(
    /^(world|example|work|word|thing|completion)-(?!search|menu|new|my|open|rename|save|share|picture|drawing|replay|program|kit).*/,
    '$1-*',
  );

async function walk(page) {
  const events = [];
  for (const kind of ['download', 'filechooser', 'popup', 'pageerror'])
    page.on(kind, (event) => events.push(kind === 'pageerror' ? `ERROR ${event}` : kind));
  page.on('dialog', (dialog) => dialog.accept());
  const picture = () => page.screenshot();
  const settle = () => page.waitForTimeout(SETTLING);
  const home = async () => {
    for (let attempt = 0; attempt < 5; attempt++) {
      const { things } = await page.evaluate(look);
      const tags = new Set(things.map(({ tag }) => tag));
      if (tags.has('menu') && tags.has('run')) return;
      if (tags.has('edit-done') && tags.has('menu')) await tap(things.find(({ tag }) => tag === 'edit-done'));
      else await page.keyboard.press('Escape');
      await page.waitForTimeout(500);
    }
    events.push('reloaded');
    await loadAgain(page);
    await page.waitForFunction(() => document.querySelector('#robotran-words [data-tag="menu"]'), null, {
      timeout: 60_000,
    });
    await settle();
  };
  const tap = async ({ x, y }) => {
    await page.touchscreen.tap(x, y);
    await settle();
  };
  const pressed = new Set();
  const results = [];
  const queue = [[]];
  while (queue.length > 0 && results.length < Number(most)) {
    const way = queue.shift();
    for (let unpressed = true; unpressed && results.length < Number(most);) {
      await home();
      let now = await page.evaluate(look);
      for (const step of way) {
        const thing = now.things.find(({ tag }) => tag === step);
        if (!thing) break;
        await tap(thing);
        now = await page.evaluate(look);
      }
      // Presses all controls that do not leave the current path.
      for (;;) {
        const thing = now.things.find(({ tag }) => !pressed.has(kindOf(tag)));
        unpressed = thing !== undefined;
        if (!unpressed || results.length >= Number(most)) break;
        pressed.add(kindOf(thing.tag));
        events.length = 0;
        const before = await picture();
        await tap(thing);
        const after = await picture();
        const then = await page.evaluate(look);
        const name = `${String(results.length).padStart(3, '0')}-${[...way, thing.tag].join('_')}`.slice(0, 90);
        await writeFile(path.join(folder, `${name}.png`), after);
        const same = before.equals(after) && now.words === then.words && events.length === 0;
        results.push({ name, same, events: [...events] });
        console.log(`${same ? 'NOTHING ' : '        '}${name} ${events.join(' ')}`);
        const isNew = then.things.some(
          ({ tag }) => !pressed.has(kindOf(tag)) && !now.things.some((other) => other.tag === tag),
        );
        if (isNew && way.length < DEEPEST) queue.unshift([...way, thing.tag]);
        const left = now.things.some(
          ({ tag }) => !pressed.has(kindOf(tag)) && !then.things.some((other) => other.tag === tag),
        );
        if (left || isNew) break;
        now = then;
      }
    }
  }
  return results;
}

await mkdir(folder, { recursive: true });
const browser = await startBrowser();
const site = await serve(process.env.PAGE);
const { page, troubles } = await openPage(browser, site, {
  drawn: true, width, height, hasTouch: true, welcome: true });
await page.screenshot({ path: path.join(folder, '000-welcome.png') });
await page.keyboard.press('Escape');
await page.waitForTimeout(SETTLING);
if (language === 'java') {
  if (await page.evaluate(() => document.querySelector('[data-tag="add-program"]') === null)) {
    const { x, y } = await page.evaluate(() => {
      const box = document.querySelector('[data-tag="tab-program"]').getBoundingClientRect();
      return { x: box.left + 10, y: box.top + 10 };
    });
    await page.touchscreen.tap(x, y);
  }
  await choose(page, 'add-program', 'new-java');
}
const results = await walk(page);
const nothing = results.filter(({ same }) => same);
await writeFile(path.join(folder, 'report.json'), JSON.stringify({ results, troubles }, null, 1));
console.log(
  `${results.length} presses, ${nothing.length} changed nothing${troubles.length ? `; troubles: ${troubles.join(' | ')}` : ''}`,
);
await browser.close();
site.stop();
