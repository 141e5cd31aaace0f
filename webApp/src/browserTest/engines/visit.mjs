// A visit to the page, step by step, that begins anew where the browser itself breaks down.
import { serve } from '../serve.mjs';

/**
 * How often a browser may crash in one visit. WebKitGTK 2.50.6 does now and then (2 of 14 visits): its interpreter of
 * WebAssembly reads at a wild address while the page starts, always at the same instruction. A page can neither cause
 * nor prevent that.
 */
const MAX_CRASHES = 3;

/**
 * `open` opens an empty page. Each step gets the page and the site, in the state in which the step before it has left
 * them.
 */
export class Visit {
  constructor(open) {
    this.open = open;
    this.done = [];
    this.crashes = 0;
  }

  /**
   * Takes a step. After a crash of the browser it is told to `tell`, all earlier steps are taken again in a new
   * browser, and this one too.
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
