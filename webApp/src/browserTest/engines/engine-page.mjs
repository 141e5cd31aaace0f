// A page of a browser that Playwright does not drive, with as much of Playwright's `Page` as the tests of all engines
// need.
import { writeFile } from 'node:fs/promises';
import { clicked, pressed, typed } from './actions.mjs';

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * `size` is that of the page, in CSS pixels. `remote` is what a protocol does for it: `navigate(address)`, `reload()`,
 * `call(text, argument)` of a function's text in the page, whose answer, a string or a promise of one, it brings;
 * `perform(actions)`, `capture()` of a PNG in base64, `close()`.
 */
export class EnginePage {
  constructor(size, remote) {
    this.remote = remote;
    this.viewportSize = () => size;
    this.mouse = { click: (x, y) => remote.perform(clicked(x, y)) };
    this.keyboard = { press: (keys) => remote.perform(pressed(keys)), type: (text) => remote.perform(typed(text)) };
  }

  goto = (address) => this.remote.navigate(address);

  reload = () => this.remote.reload();

  waitForTimeout = pause;

  async evaluate(action, argument = null) {
    const text = `async (argument) => JSON.stringify(await (${action})(JSON.parse(argument))) ?? 'null'`;
    return JSON.parse(await this.remote.call(text, JSON.stringify(argument)));
  }

  async waitForFunction(action, argument = null, { timeout = 30_000 } = {}) {
    const end = Date.now() + timeout;
    for (;;) {
      const answer = await this.evaluate(action, argument);
      if (answer) return { jsonValue: async () => answer };
      if (Date.now() > end) throw new Error(`not within ${timeout} ms: ${action} of ${JSON.stringify(argument)}`);
      await pause(100);
    }
  }

  locator(selector) {
    const count = () => this.evaluate((wanted) => document.querySelectorAll(wanted).length, selector);
    return {
      count,
      first: () => this.locator(selector),
      waitFor: ({ state, timeout }) =>
        this.waitForFunction(
          ([wanted, there]) => (document.querySelector(wanted) !== null) === there,
          [selector, state === 'attached'],
          { timeout },
        ),
    };
  }

  async screenshot({ path } = {}) {
    const picture = Buffer.from(await this.remote.capture(), 'base64');
    if (path) await writeFile(path, picture);
    return picture;
  }

  /** Whether the page answers nothing any more, since the process that held it is gone. */
  crashed = () =>
    this.evaluate(() => true).then(
      () => false,
      () => true,
    );

  close = () => this.remote.close();
}
