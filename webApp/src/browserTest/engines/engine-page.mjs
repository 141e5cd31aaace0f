// A page of a browser that Playwright does not drive. It has the parts of Playwright's `Page` that the engine tests
// need.
import { writeFile } from 'node:fs/promises';
import { clicked, pressed, typed } from './actions.mjs';

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/**
 * `size` is the page size in CSS pixels. `remote` implements the page over a protocol: `navigate(address)`, `reload()`,
 * `call(text, argument)`, which calls the function with this source in the page and returns its string or awaited
 * string, `perform(actions)`, `capture()`, which returns a PNG in base64, and `close()`.
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
      getAttribute: (name) =>
        this.evaluate(([wanted, attribute]) => document.querySelector(wanted).getAttribute(attribute), [selector, name]),
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

  /** Whether the page no longer responds because its process is gone. */
  crashed = () =>
    this.evaluate(() => true).then(
      () => false,
      () => true,
    );

  close = () => this.remote.close();
}
