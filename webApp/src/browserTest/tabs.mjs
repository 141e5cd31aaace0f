// Tabs of one browser.

/** Closes a tab as a pupil does, and waits until it is gone, which Playwright does not. */
export async function closeTab(page) {
  const gone = page.waitForEvent('close');
  await page.close({ runBeforeUnload: true });
  await gone;
}
