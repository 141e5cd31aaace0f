// Records which functions of Skiko the tests call, for ./gradlew :webApp:recordSkiko; see docs/hosting.md.
import { appendFile } from 'node:fs/promises';

/** If the file SKIKO_CALLS is wanted, adds the numbers of the functions that `page` calls to it. Skiko must be a marked one. */
export async function recordSkikoCalls(page) {
  const file = process.env.SKIKO_CALLS;
  if (!file) return;
  await page.exposeFunction('recordCalls', (numbers) => appendFile(file, numbers.map((number) => `${number}\n`).join('')));
  await page.addInitScript(watchCalls);
}

/** Runs in the page: looks each half second for functions that have been called for the first time. */
function watchCalls() {
  const NAME = /^called (\d+)$/;
  const instantiate = WebAssembly.instantiate.bind(WebAssembly);
  WebAssembly.instantiate = async (...values) => {
    const instance = await instantiate(...values);
    let marks = Object.entries(instance.exports ?? {}).filter(([name]) => NAME.test(name));
    const isCalled = ([, mark]) => mark.value === 1;
    if (marks.length > 0) {
      setInterval(() => {
        const called = marks.filter(isCalled);
        marks = marks.filter((each) => !isCalled(each));
        if (called.length > 0) globalThis.recordCalls(called.map(([name]) => Number(NAME.exec(name)[1])));
      }, 500);
    }
    return instance;
  };
}
