// What the page has saved in the browser's database.
import assert from 'node:assert/strict';
import { PATIENCE } from './words.mjs';

/** All saved projects as text, sorted by name. */
export const savedProjects = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve, reject) => {
        const request = indexedDB.open('robotran', 1);
        request.onerror = () => reject(request.error);
        request.onsuccess = () => {
          const texts = request.result.transaction('texts').objectStore('texts');
          const names = texts.getAllKeys();
          const all = texts.getAll();
          all.onsuccess = () => resolve(all.result.filter((_, place) => names.result[place].startsWith('work-')));
        };
      }),
  );

/** Waits until `test` returns true for the saved projects, and returns them. */
async function worksSuch(page, test) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const works = await savedProjects(page);
    if (test(works)) return works;
    assert.ok(Date.now() < end, `${works.length} are kept: ${works}`);
    await page.waitForTimeout(100);
  }
}

/** Waits until a saved project contains `part`. */
export const isKept = (page, part) => worksSuch(page, (works) => works.some((text) => text.includes(part)));

/** Waits until this number of projects is saved. */
export const areSaved = (page, count) => worksSuch(page, (works) => works.length === count);
