// An assignment in a frame of a page of a school.
import assert from 'node:assert/strict';
import { appInFrame, pageAround } from './frame.mjs';
import { linkTo } from './link.mjs';
import { onPage, TABLET } from './set-up.mjs';

export const world = {
  format: 'robotran-world',
  version: 2,
  title: 'To the mark',
  task: 'Drive to the mark.',
  paper: { width: 100, height: 80 },
  robots: [{ start: { x: 30, y: 40, heading: 0 } }],
  goals: [{ kind: 'reach', region: { rectangle: { x: 60, y: 30, width: 20, height: 20 } } }],
};
const program = { name: 'mark.robo', language: 'robolang', text: ['forward 5'] };
export const assignment = {
  format: 'robotran-project',
  version: 1,
  robots: [{ name: 'yellow', programs: [program] }],
  assignment: { id: 'mark-1', text: ['Use `forward`.'] },
  world,
};
const link = linkTo('p', assignment);

/**
 * Shows the assignment in a frame of a page at another origin, while `use` runs. `origins` are those that the site
 * allows; `work` is what that page brings back.
 */
export const inFrame = ({ origins, work = '', isSame = false, shown = link }, use) =>
  onPage(TABLET, async ({ page: first, site, troubles }) => {
    const other = isSame ? site.address : site.address.replace('127.0.0.1', 'localhost');
    site.pages['embedding.json'] = JSON.stringify({ origins: origins(new URL(other).origin) });
    site.pages['around.html'] = pageAround(`${site.address}?embed=assignment${shown}`, work);
    const page = await first.context().newPage();
    await page.setViewportSize(TABLET);
    page.on('pageerror', (error) => troubles.push(String(error)));
    try {
      await page.goto(`${other}around.html`);
      await use({ page, app: await appInFrame(page), site });
      assert.deepEqual(troubles, []);
    } finally {
      site.pages = {};
    }
  });
