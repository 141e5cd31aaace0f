// A link opens its program in blocks.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { areBlocks } from '../blocks.mjs';
import { linkTo } from '../link.mjs';
import { photograph } from '../page.mjs';
import { onPage, TABLET } from '../set-up.mjs';
import { press } from '../words.mjs';

const PROJECT = {
  format: 'robotran-project',
  version: 1,
  world: { format: 'robotran-world', version: 2, title: 'A sheet', paper: { width: 80, height: 60 }, robots: [{ start: { x: 20, y: 15, heading: 0 } }] },
  robots: [
    {
      name: 'yellow',
      programs: [{ name: 'edge.robo', language: 'robolang', text: ['repeat 2 times', '  forwrd 3', 'end'], view: 'blocks' }],
    },
  ],
};

test('a link opens its program in blocks, and a mistake is a loose line with a fix', () =>
  onPage(
    { ...TABLET, address: linkTo('p', PROJECT) },
    async ({ page, troubles }) => {
      await areBlocks(page, ['repeat 2 times', 'line with a mistake: forwrd 3', 'End of']);
      await photograph(page, 'blocks-mistake');
      await press(page, 'fix');
      await areBlocks(page, ['repeat 2 times', 'forward 3', 'End of']);
      assert.deepEqual(troubles, []);
    },
  ));
