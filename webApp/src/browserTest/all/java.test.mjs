// Runs leJOS programs in the built page.
import assert from 'node:assert/strict';
import path from 'node:path';
import { assertRecordedRun } from '../page.mjs';
import { browserOptions, onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

for (const [brick, folder, runs] of [
  ['an RCX', 'lejos', process.env.EXPECTED_JAVA_RUNS],
  ['an NXT', 'nxj', process.env.EXPECTED_NXJ_RUNS],
])
  test(`every Java example for ${brick} makes its recorded run in the browser, bit for bit`, () =>
    onPage(TABLET, async ({ page, troubles }) => {
      const isOne = (file) => file.endsWith('.java') && path.basename(path.dirname(file)) === folder;
      const examples = process.env.EXAMPLES.split(path.delimiter).filter(isOne);
      assert.ok(examples.length >= 15, `${examples.length} examples`);
      for (const example of examples) await assertRecordedRun(page, example, runs);
      assert.deepEqual(troubles, []);
    }));

test('a mistake in a Java program is told with its line', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const program =
      'public class Wrong {\n    public static void main(String[] args) {\n        int number = tru;\n    }\n}\n';
    await assert.rejects(
      page.evaluate((text) => globalThis.robotran.run(text, 1000, 'Wrong.java'), program),
      /Line 3: /,
    );
    assert.deepEqual(troubles, []);
  }));
