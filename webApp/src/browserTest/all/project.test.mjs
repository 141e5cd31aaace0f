// Runs whole projects in the built page: worlds with many elements, several robots, noise, and external inputs.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { browserOptions, onPage, TABLET } from '../set-up.mjs';
import { test } from '../tried-again.mjs';

// Runs are the same in the optimised code that pupils get.
browserOptions.optimizing = true;

test('ten projects full of things make their recorded runs in the browser, bit for bit', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    const folder = process.env.EXPECTED_PROJECT_RUNS;
    const projects = (await readdir(folder)).filter((name) => name.endsWith('.robotran'));
    assert.equal(projects.length, 10);
    for (const name of projects) {
      const text = await readFile(path.join(folder, name), 'utf8');
      const run = await page.evaluate((project) => globalThis.robotran.runProject(project, 60_000), text);
      const expected = await readFile(path.join(folder, name.replace('.robotran', '.report.json')), 'utf8');
      assert.equal(`${run.report}\n`, expected, name);
    }
    assert.deepEqual(troubles, []);
  }));

test('a broken project is refused with what is wrong and where', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await assert.rejects(
      page.evaluate(() => globalThis.robotran.runProject('{\n"format": 7}', 1000)),
      /project/,
    );
    await assert.rejects(
      page.evaluate(() => globalThis.robotran.runProject('{\n"format" 7}', 1000)),
      /Line 2/,
    );
    assert.deepEqual(troubles, []);
  }));
