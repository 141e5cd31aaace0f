// What a class does by touch without a server: files, and what is for teachers.
import path from 'node:path';
import { appears, words } from './words.mjs';

/** Saves what is downloaded while `act` runs in `folder`, and returns its path. */
export async function downloaded(page, folder, act) {
  const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60_000 }), act()]);
  const file = path.join(folder, download.suggestedFilename());
  await download.saveAs(file);
  return file;
}

/** Chooses `files` in the dialog that opens while `act` runs. */
export async function chosen(page, files, act) {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), act()]);
  await chooser.setFiles(files);
}

/** Taps into the field `tag` and types `text` in place of what is there, as with a keyboard on the screen. */
export async function type(page, finger, tag, text) {
  await finger.press(tag);
  await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Delete');
  await page.keyboard.insertText(text);
}

/** Shows the program as text, whatever it was before. */
export async function showText(page, finger) {
  await finger.press('view-switch');
  await finger.press('view-text');
  await appears(page, 'program');
}

/** Opens the menu of the project and chooses a file, behind "Files and more". */
export async function openFile(page, finger) {
  await finger.press('work-menu');
  for (const item of ['work-more', 'work-open']) await choose(page, finger, item);
}

/** Opens what is for teachers, and there presses `button`. */
export async function asTeacher(page, finger, button) {
  await finger.press('menu');
  await choose(page, finger, 'menu-teachers');
  await finger.press(button);
}

/** Chooses `item` in an open menu; it may have to be scrolled to. A menu that has just opened may miss a touch. */
async function choose(page, finger, item) {
  for (let attempt = 0; attempt < 5; attempt++) {
    const place = await finger.placeOf(item);
    const below = place.top + place.height - page.viewportSize().height;
    if (below > 0) {
      const from = { x: place.x, y: page.viewportSize().height - 60 };
      await finger.drag(from, { x: from.x, y: from.y - below - 60 });
      continue;
    }
    await page.touchscreen.tap(place.x, place.y);
    try {
      await words(page, item).waitFor({ state: 'detached', timeout: 3_000 });
      return;
    } catch {
      // The menu is still open: try again.
    }
  }
  throw new Error(`${item} cannot be chosen`);
}
