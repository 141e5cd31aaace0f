// The content security policy of the page is enforced, and files can be cached for ever.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { violations, watch } from '../policy.mjs';
import { onPage, TABLET } from '../set-up.mjs';

test('the policy holds: no code from texts, no script in the page, nothing from elsewhere', () =>
  onPage({ ...TABLET, prepare: watch }, async ({ page }) => {
    const outcome = await page.evaluate(async () => {
      const tell = (action) => {
        try {
          action();
          return 'allowed';
        } catch (error) {
          return error.name;
        }
      };
      const script = document.createElement('script');
      script.textContent = 'globalThis.intruder = true';
      document.head.append(script);
      const style = document.createElement('style');
      style.textContent = 'body { display: none }';
      document.head.append(style);
      return {
        // Delayed, since code evaluated by the debugger is exempt from the policy.
        text: await new Promise((resolve) => setTimeout(() => resolve(tell(() => new Function('return 1')())))),
        intruder: globalThis.intruder ?? false,
        hidden: getComputedStyle(document.body).display === 'none',
        elsewhere: await fetch('https://robotran.example/').then(
          () => 'allowed',
          (error) => error.name,
        ),
      };
    });
    assert.deepEqual(outcome, { text: 'EvalError', intruder: false, hidden: false, elsewhere: 'TypeError' });
    const directives = new Set((await violations(page)).map((violation) => violation.split(' ')[0]));
    assert.deepEqual([...directives].sort(), ['connect-src', 'script-src', 'script-src-elem', 'style-src-elem']);
  }));

test('all files but four say in their names what is in them', async () => {
  const top = (await readdir(process.env.PAGE)).sort();
  assert.deepEqual(top, ['embedding.json', 'files', 'index.html', 'manifest.webmanifest', 'service-worker.js']);
  const files = await readdir(path.join(process.env.PAGE, 'files'));
  assert.deepEqual(
    files.filter((name) => !/\.[0-9a-f]{16}\.\w+$/.test(name) && !name.endsWith('.LICENSE.txt')),
    [],
  );
  assert.doesNotMatch(await readFile(path.join(process.env.PAGE, 'index.html'), 'utf8'), /\{\{|https?:/);
});
