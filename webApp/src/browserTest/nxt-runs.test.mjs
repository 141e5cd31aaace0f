// Runs programs on an NXT in the built page. Its class library is fetched with the first Java program for it.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { assertRecordedRun } from './page.mjs';
import { browserOptions, onPage, TABLET } from './set-up.mjs';
import { test } from './tried-again.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

const examples = process.env.EXAMPLES.split(path.delimiter);

test('every Java example for an NXT makes its recorded run in the browser, bit for bit', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const forNxt = examples.filter((file) => /nxj\/[^/]*\.java$/.test(file));
    assert.ok(forNxt.length >= 15, `${forNxt.length} examples`);
    for (const example of forNxt) await assertRecordedRun(page, example, process.env.EXPECTED_NXJ_RUNS);
    assert.deepEqual(troubles, []);
  }));

test('every example in Robolang that an NXT can run makes its recorded run on one in the browser', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const recorded = (file) =>
      existsSync(path.join(process.env.EXPECTED_NXT_RUNS, `${path.basename(file, '.robo')}.report.json`));
    const forNxt = examples.filter((file) => file.endsWith('.robo') && recorded(file));
    assert.ok(forNxt.length > 20, `${forNxt.length} examples`);
    for (const example of forNxt) await assertRecordedRun(page, example, process.env.EXPECTED_NXT_RUNS, 'nxt');
    assert.deepEqual(troubles, []);
  }));

test('the library of an NXT is fetched with its first Java program, not before and not again', () =>
  onPage(TABLET, async ({ page, troubles, fetched }) => {
    const libraries = () => fetched.filter((address) => /nxj-/.test(new URL(address).pathname)).length;
    const run = (text, name, brick) =>
      page.evaluate(([program, file, on]) => globalThis.robotran.run(program, 1_000, file, on), [text, name, brick]);
    const program = (line) => `public class P { public static void main(String[] args) { ${line} } }`;

    await run('beep', 'p.robo', 'nxt');
    await run(program('josx.platform.rcx.Motor.A.stop();'), 'P.java');
    assert.equal(libraries(), 0);
    await run(program('lejos.nxt.Motor.A.rotate(90);'), 'P.java');
    const first = libraries();
    assert.ok(first > 0);
    await run(program('lejos.nxt.Motor.A.rotate(45);'), 'P.java');
    assert.equal(libraries(), first);
    assert.deepEqual(troubles, []);
  }));
