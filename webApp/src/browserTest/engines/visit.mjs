// A sequence of test steps on the page that starts over if the browser itself crashes.
import { serve } from '../serve.mjs';

/**
 * The max number of browser crashes in one visit. WebKitGTK 2.50.6 crashes in 2 of 14 visits: its WebAssembly
 * interpreter reads an invalid address while the page starts, always at the same instruction. The page can neither
 * cause nor prevent this.
 */
const MAX_CRASHES = 3;

/** `open` opens an empty page. Each step gets the page and the site as the previous step left them. */
export class Visit {
  constructor(open) {
    this.open = open;
    this.done = [];
    this.crashes = 0;
  }

  /**
   * Runs a step. If the browser crashes, reports it to `tell` and repeats all earlier steps and this one in a new
   * browser.
   */
  async step(action, tell) {
    for (const taken of this.page ? [action] : [...this.done, action]) {
      try {
        await this.begin();
        await taken(this.page, this.site);
      } catch (error) {
        if (!(await this.page?.crashed()) || ++this.crashes > MAX_CRASHES) throw error;
        tell(`the browser itself crashed (${error.message}); the visit begins anew`);
        await this.end();
        return this.step(action, tell);
      }
    }
    this.done.push(action);
  }

  async begin() {
    this.site ??= await serve(process.env.PAGE);
    this.page ??= await this.open();
  }

  async end() {
    await this.page?.close();
    this.site?.stop();
    this.page = this.site = undefined;
  }
}
