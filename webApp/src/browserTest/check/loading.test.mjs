// What the page shows before the app has loaded, and if it cannot load.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photograph } from '../page.mjs';
import { laterFiles } from '../parts.mjs';
import { appIsThere, hold, isCarriedOut, loadingWords, site, visit } from '../visit.mjs';
import { appears, PATIENCE, reports } from '../words.mjs';

test("the page shows how far it is, in the reader's language, until the app is there", async () => {
  const { route, goOn } = hold();
  const page = await visit({ locale: 'de-AT', route });
  assert.equal(await loadingWords(page), 'Robotran macht sich bereit.');
  assert.equal(await page.getAttribute('html', 'lang'), 'de');
  const progress = () => page.evaluate(() => document.getElementById('loading-progress').value);
  await page.waitForFunction(() => document.getElementById('loading-progress').value > 0.2, null, { timeout: PATIENCE });
  assert.ok((await progress()) < 0.9, `${await progress()}`);
  await photograph(page, 'loading');
  goOn();
  await appIsThere(page);
  await page.context().close();
});

test('no file of the app is requested twice, not even the font of programs', async () => {
  const page = await visit({ viewport: { width: 1280, height: 800 } });
  await appIsThere(page);
  // A part for which the page must stand still is asked for once more.
  await page.waitForFunction((count) => performance.getEntriesByType('resource').filter(({ name }) => /-rest/.test(name)).length === count, (await laterFiles(page)).length);
  await page.keyboard.press('Escape'); // The welcome is closed, so the program is drawn.
  await appears(page, 'program');
  await page.waitForLoadState('networkidle');
  const requested = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
  const files = requested.filter((name) => /\.(wasm|js|ttf)$/.test(name));
  assert.ok(files.some((name) => name.endsWith('.ttf')));
  assert.deepEqual(
    files.filter((name, place) => files.indexOf(name) !== place),
    [],
  );
  await page.context().close();
});

test('the robot of the greeting draws, and stands still for those who prefer less motion', async () => {
  const moves = () => document.getAnimations().length > 0;
  const ink = () => getComputedStyle(document.querySelector('.ink')).strokeDashoffset;
  for (const reducedMotion of ['no-preference', 'reduce']) {
    const page = await visit({ route: hold().route, reducedMotion });
    if (reducedMotion === 'reduce') {
      assert.equal(await page.evaluate(moves), false);
      assert.equal(parseFloat(await page.evaluate(ink)), 0);
    } else {
      const before = parseFloat(await page.evaluate(ink));
      await page.waitForFunction((first) => parseFloat(getComputedStyle(document.querySelector('.ink')).strokeDashoffset) < first, before);
    }
    await page.context().close();
  }
});

test('a square that is chosen on the greeting is drawn when the app is there', () =>
  isCarriedOut('square', (page) => reports(page, (report) => report.inkCentimetres > 1)));

test('later visits, links and embedded pages are not greeted with choices', async () => {
  const { route, goOn } = hold();
  const page = await visit({ route });
  goOn();
  await appIsThere(page);
  const again = await page.context().newPage();
  const shown = async (address) => {
    await again.route('**/files/robotran.*.wasm', () => undefined);
    await again.goto(site.address + address, { waitUntil: 'domcontentloaded' });
    return again.isVisible('#greeting');
  };
  assert.equal(await shown(''), false);
  await again.evaluate(() => localStorage.clear());
  assert.equal(await shown('#p=a'), false);
  assert.equal(await shown('?embed'), false);
  assert.equal(await shown(''), true);
  await page.context().close();
});

test('a browser without Wasm GC is told so, and fetches nothing in vain', async () => {
  const before = site.asked.length;
  const page = await visit({
    locale: 'es-MX',
    colorScheme: 'dark',
    prepare: () => {
      WebAssembly.validate = () => false;
    },
  });
  assert.equal(
    await loadingWords(page),
    'Este navegador es demasiado antiguo para Robotran. Usa un Chrome, Edge, Firefox o Safari más nuevo.',
  );
  assert.equal(await page.isVisible('#loading-again'), false, 'trying again would not help');
  // What was asked for before is asked for by then.
  await page.evaluate(() => fetch('embedding.json').then(() => undefined));
  assert.deepEqual(
    site.asked.slice(before).filter((path) => /\.(js|wasm|ttf)$/.test(path)),
    [],
  );
  await photograph(page, 'loading-old-browser');
  await page.context().close();
});

test('a file that cannot be fetched is told, and trying again helps once it can be', async () => {
  site.refuse = (path) => (path.includes('/skiko.') ? 503 : null);
  const page = await visit();
  await page.waitForSelector('#loading-again', { state: 'visible', timeout: PATIENCE });
  assert.equal(await loadingWords(page), 'A part of Robotran could not be fetched. Perhaps the network is away or blocks it.');
  assert.equal(await page.isVisible('#greeting'), false, 'nothing could be carried out');
  await photograph(page, 'loading-broken');

  site.refuse = () => 503;
  await page.click('#loading-again');
  await page.waitForFunction(() => /still away/.test(document.getElementById('loading-words').textContent));

  site.refuse = () => null;
  await page.focus('#loading-again');
  await page.keyboard.press('Enter');
  await appIsThere(page);
  await page.context().close();
});

test('a page in place of a file, as a network to be logged into sends it, is a file that could not be fetched', async () => {
  const page = await visit({
    route: [
      '**/files/physics.*.wasm',
      (route) => route.fulfill({ contentType: 'text/html', body: '<p>Log in first</p>' }),
    ],
  });
  await page.waitForSelector('#loading-again', { state: 'visible', timeout: PATIENCE });
  assert.match(await loadingWords(page), /could not be fetched/);
  await page.context().close();
});

test('a script that is not there is told, too', async () => {
  site.refuse = (path) => (/\/robotran\.\w+\.js$/.test(path) ? 404 : null);
  const page = await visit();
  await page.waitForSelector('#loading-again', { state: 'visible', timeout: PATIENCE });
  assert.match(await loadingWords(page), /could not be fetched/);
  site.refuse = () => null;
  await page.context().close();
});

test('a browser that cannot draw is told why', async () => {
  const page = await visit({
    prepare: () => {
      HTMLCanvasElement.prototype.getContext = () => null;
    },
  });
  await page.waitForSelector('#loading-again', { state: 'visible', timeout: PATIENCE });
  assert.match(await loadingWords(page), /WebGL/);
  await page.context().close();
});

test('what went wrong is told under Details, for somebody who is asked for help', async () => {
  const page = await visit({ locale: 'de-AT', prepare: startInVain });
  await page.waitForSelector('#loading-details', { state: 'visible', timeout: PATIENCE });
  assert.equal(await loadingWords(page), 'Robotran konnte nicht starten.');
  assert.equal(await page.textContent('#loading-details summary'), 'Einzelheiten');
  assert.equal(await page.isVisible('#loading-report'), false, 'only who asks for it sees it');
  await page.click('#loading-details summary');
  const report = await page.innerText('#loading-report');
  const version = await page.evaluate(() => JSON.parse(document.getElementById('site').textContent).version);
  assert.match(report, /RangeError: something odd/);
  assert.match(report, /Chrome\/\d+/);
  assert.ok(report.includes(`Robotran ${version}`) && report.includes('de-AT'), report);
  await photograph(page, 'loading-details');
  await page.context().close();
});

/** Runs in the page: makes an API fail that Compose needs to start. */
function startInVain() {
  const { Locale } = Intl;
  Intl.Locale = function (tag) {
    if (document.readyState !== 'loading') throw new RangeError('something odd');
    return new Locale(tag);
  };
}

test('a language that is none counts as English', async () => {
  const prepare = () => {
    Object.defineProperty(Navigator.prototype, 'language', { get: () => 'C', configurable: true });
    Object.defineProperty(Navigator.prototype, 'languages', { get: () => ['C'], configurable: true });
  };
  const page = await visit({ prepare });
  await appIsThere(page);
  assert.equal(await page.getAttribute('html', 'lang'), 'en');
  await page.waitForSelector('#robotran-words [data-tag]', { state: 'attached' });
  await page.context().close();
});
