// A pupil types a program, runs it, and finds it after a reload.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isKept } from '../kept.mjs';
import { photograph, reload } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { press, reports, says, writeProgram } from '../words.mjs';

const IN_MEMORY = /^robotran-work 1\n/;

test('a program that is typed runs, and is there again after a reload', () =>
  onPage(TABLET, async ({ page, troubles }) => {
    await writeProgram(page, 'pen down\nrepeat 2 times\nforward 15\nturn left 180 degrees\nend');
    await says(page, 'status', /Press Run/);
    await press(page, 'run');
    await reports(page, (report) => report.status === 'ended' && report.inkCentimetres > 10);
    await photograph(page, 'typed-program');
    const works = await isKept(page, 'forward 15');
    assert.match(works[0], IN_MEMORY);
    await reload(page);
    await says(page, 'program', /repeat 2 times\n.*forward 15\n.*turn left 180 degrees\n.*end/);
    assert.deepEqual(troubles, []);
  }));
