// A compiler that never answers.
import assert from 'node:assert/strict';
import { photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';
import { choose, isSaid, says, writeProgram } from '../words.mjs';

/** Runs in a page: the worker that compiles Java is there and never answers. */
function neverCompiles() {
  const Original = Worker;
  globalThis.Worker = function Worker(address, options) {
    if (!/ecj-worker/.test(address)) return new Original(address, options);
    const silent = { postMessage: () => undefined, terminate: () => (globalThis.ended = (globalThis.ended ?? 0) + 1) };
    setTimeout(() => silent.onmessage({ data: { kind: 'ready' } }));
    return silent;
  };
}

test('a Java program that keeps the compiler busy has a mistake that says so, and the page stays alive', () =>
  onPage({ ...TABLET, prepare: neverCompiles }, async ({ page, troubles }) => {
    await choose(page, 'add-program', 'new-java');
    await says(page, 'program', /class/);
    await writeProgram(page, 'class A');
    await says(page, 'program', /class A/);
    await isSaid(page, /keeps the compiler for Java busy for too long/);
    assert.ok((await page.evaluate(() => globalThis.ended)) >= 1, 'the worker is ended');
    await photograph(page, 'compiler-busy');
    assert.deepEqual(troubles, []);
  }));
