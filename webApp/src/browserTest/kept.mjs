// What the page has kept in its browser's database.
import assert from 'node:assert/strict';

/** All texts of works, in the order of their names. */
export const keptWorks = (page) =>
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

/** Waits until `test`, a function of what is kept, says yes; answers what is kept then. */
async function worksSuch(page, test) {
  const end = Date.now() + 20_000;
  for (;;) {
    const works = await keptWorks(page);
    if (test(works)) return works;
    assert.ok(Date.now() < end, `${works.length} are kept: ${works}`);
    await page.waitForTimeout(100);
  }
}

/** Waits until a work is kept that holds `part`. */
export const isKept = (page, part) => worksSuch(page, (works) => works.some((text) => text.includes(part)));

/** Waits until so many works are kept. */
export const areKept = (page, count) => worksSuch(page, (works) => works.length === count);
