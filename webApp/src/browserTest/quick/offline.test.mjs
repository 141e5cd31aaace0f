// The app without a network, in a subfolder of the server.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isKeptOffline, isThere, newSite, openKept, runJava } from '../offline.mjs';
import { loadAgain } from '../page.mjs';
import { press } from '../words.mjs';

test('after the first visit the app opens, and compiles Java, without a network', async () => {
  const site = await newSite({ under: '/some/school/' });
  const { page, troubles } = await openKept(site);
  await isKeptOffline(page);
  const compilers = site.asked.filter((path) => /\/ecj\.\w+\.wasm$/.test(path));
  assert.equal(compilers.length, 1, 'the compiler is fetched when all else is there');
  assert.equal(
    site.asked.filter((path) => /\/noto_emoji\.\w+\.ttf$/.test(path)).length,
    1,
    'so is the font with emoji',
  );
  assert.ok(
    site.asked.every((path) => path.startsWith('/some/school/') || path === '/favicon.ico'),
    'all lies in the folder',
  );

  site.refuse = () => 503;
  const before = site.asked.length;
  await loadAgain(page);
  await isThere(page);
  await runJava(page);
  const font = page.waitForResponse((response) => /\/noto_emoji\./.test(response.url()));
  await press(page, 'program');
  await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
  await page.keyboard.insertText('// 🚀\n');
  assert.equal((await font).status(), 200);
  const other = await page.context().newPage();
  await other.goto(`${site.address}?from=home`);
  await isThere(other);
  assert.deepEqual(
    site.asked.slice(before).filter((path) => !/service-worker\.js$/.test(path)),
    [],
  );
  assert.deepEqual(
    troubles.filter((trouble) => !/503/.test(trouble)),
    [],
  );
  await page.context().close();
});
