// The page of hand-ins with its scanner of QR codes.
import { appears, asTeacher, chooseFile, says } from './words.mjs';

export const scanner = (page) => page.locator('dialog.robotran-scanner');

/** To draw forty centimetres. */
const WORLD = {
  format: 'robotran-world',
  version: 2,
  title: 'A long line',
  task: 'Draw a line. It needs forty centimetres.',
  paper: { width: 100, height: 80 },
  robots: [{ start: { x: 30, y: 30, heading: 0 } }],
  goals: [{ kind: 'inkLength', atLeast: 40 }],
  timeLimit: 20,
};

export async function openHandIns(page) {
  const chooser = page.waitForEvent('filechooser');
  await chooseFile(page, 'work-open');
  const buffer = Buffer.from(JSON.stringify(WORLD));
  await (await chooser).setFiles([{ name: 'line.world.json', mimeType: 'application/json', buffer }]);
  await says(page, 'task-title', /A long line/);
  await asTeacher(page, 'teachers-hand-ins');
  await appears(page, 'hand-ins-paste');
}
