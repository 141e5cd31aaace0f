// Long tests that are tried once more: only those of `all`.
import { test as declare } from 'node:test';

let isTriedAgain = false;

/**
 * Declares a test, as `test` of `node:test` does. On a machine that builds meanwhile a frame may come too late for a touch or a
 * wait. So the first test of a file that fails is tried once more, from the beginning; the results say so. What is
 * broken fails twice.
 */
export function test(name, ...rest) {
  const body = rest.pop();
  const [{ timeout, ...options } = {}] = rest;
  return declare(name, { ...options, ...(timeout && { timeout: 2 * timeout }) }, async (context) => {
    try {
      await body(context);
    } catch (error) {
      if (isTriedAgain) throw error;
      isTriedAgain = true;
      context.diagnostic(`Tried again: ${name}: ${error.stack}`);
      await body(context);
    }
  });
}
