// A short test in every engine: start, type and run a program, compile Java, open a link, and start offline.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, describe, test } from 'node:test';
import { linkTo } from '../link.mjs';
import { assertRecordedRun, photograph, putWelcomeAway, report } from '../page.mjs';
import { laterFiles } from '../parts.mjs';
import { appears, press, reports, says, writeProgram } from '../words.mjs';
import { ENGINES } from './engines.mjs';
import { Visit } from './visit.mjs';

const SIZE = { width: 1180, height: 820 };
const examples = process.env.EXAMPLES.split(path.delimiter);
const example = (name) => examples.find((file) => file.endsWith(path.join('examples', name)));

const isThere = async (page) => {
  await page.waitForFunction(
    () => {
      const details = document.getElementById('loading-details');
      if (details && !details.hidden) throw new Error(document.getElementById('loading').textContent);
      return globalThis.robotran !== undefined && document.querySelector('#robotran-words [data-tag]') !== null;
    },
    null,
    { timeout: 90_000 },
  );
};

for (const [name, open] of Object.entries(ENGINES)) {
  describe(name, { skip: open === null && `${name} is not here` }, () => {
    const visit = new Visit(() => open(SIZE));
    const step = (title, action) => test(title, (t) => visit.step(action, (text) => t.diagnostic(text)));

    after(() => visit.end());

    step(`the page starts in ${name}, and the robot draws the square`, async (page, site) => {
      await page.goto(site.address);
      await isThere(page);
      await putWelcomeAway(page);
      await press(page, 'run');
      await reports(page, (report) => report.status === 'ended');
      const { inkCentimetres } = await report(page);
      assert.ok(inkCentimetres > 79 && inkCentimetres < 81, `${inkCentimetres} cm of ink`);
      await photograph(page, `engine-${name.toLowerCase()}`);
      // A page that calls a function of a later part requests that part a second time, and stands still meanwhile.
      const later = await page.evaluate(() =>
        performance.getEntriesByType('resource').flatMap(({ name: address }) => /files\/[\w]+-rest.*/.exec(address) ?? []),
      );
      assert.deepEqual(later.sort(), (await laterFiles(page)).sort(), 'record again: ./gradlew :webApp:recordFirstPart');
    });

    step(`a program that is typed in ${name} runs`, async (page) => {
      await writeProgram(page, 'pen down\nforward 12');
      await says(page, 'status', /Run/);
      await press(page, 'run');
      await reports(
        page,
        (report) => report.status === 'ended' && report.inkCentimetres > 11 && report.inkCentimetres < 13,
      );
    });

    step(`${name} makes recorded runs, in Robolang and in Java, bit for bit`, async (page) => {
      await assertRecordedRun(page, example('square.robo'), process.env.EXPECTED_RUNS);
      await assertRecordedRun(page, example(path.join('lejos', 'Square.java')), process.env.EXPECTED_JAVA_RUNS);
      await assertRecordedRun(page, example(path.join('nxj', 'Square.java')), process.env.EXPECTED_NXJ_RUNS);
    });

    step(`without a network the page is there again in ${name}, with the work and with Java`, async (page, site) => {
      await page.waitForFunction(() =>
        navigator.serviceWorker
          .getRegistration()
          .then(
            (registration) =>
              registration?.active?.state === 'activated' && !registration.installing && !registration.waiting,
          ),
      );
      site.refuse = () => 503;
      const asked = site.asked.length;
      await page.reload();
      await isThere(page);
      await says(page, 'program', /forward 12/);
      await assertRecordedRun(page, example(path.join('lejos', 'Square.java')), process.env.EXPECTED_JAVA_RUNS);
      await assertRecordedRun(page, example(path.join('nxj', 'Square.java')), process.env.EXPECTED_NXJ_RUNS);
      assert.deepEqual(
        site.asked.slice(asked).filter((path) => !/service-worker\.js$/.test(path)),
        [],
      );
    });

    step(`${name} opens a link`, async (page) => {
      const project = JSON.parse(
        await readFile(path.join(process.env.EXPECTED_PROJECT_RUNS, 'full-of-things-0.robotran'), 'utf8'),
      );
      const link = linkTo('p', project);
      await page.evaluate((fragment) => {
        location.hash = fragment;
      }, link);
      await appears(page, 'thing-block-0');
      assert.equal(await page.evaluate(() => location.hash), '');
      await says(page, 'program', /^(?!.*forward 12)/);
    });
  });
}
