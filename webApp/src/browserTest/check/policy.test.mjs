// The app needs nothing that the content security policy of the page forbids.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { violations, watch } from '../policy.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { press } from '../words.mjs';

test('the app needs nothing that its policy forbids, and nothing from elsewhere', () =>
  onPage({ ...TABLET, prepare: watch, serviceWorkers: 'allow' }, async ({ page, site, troubles, fetched }) => {
    await press(page, 'run');
    await page.keyboard.press('Tab');
    await page.keyboard.type('a');
    await page.evaluate(() =>
      globalThis.robotran.run('public class A { public static void main(String[] a) { } }', 1000, 'A.java'),
    );
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    assert.deepEqual(await violations(page), []);
    assert.deepEqual(
      fetched.filter((address) => !address.startsWith(site.address) && !/^(data|blob):/.test(address)),
      [],
    );
    assert.deepEqual(troubles, []);
  }));
