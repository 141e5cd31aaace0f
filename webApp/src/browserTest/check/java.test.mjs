// The compiler for Java is a separate module, loaded on first use.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { onPage, TABLET } from '../set-up.mjs';

test('the compiler is fetched with the first Java program, the classes of an NXT with the first for it, and none again', () =>
  onPage(TABLET, async ({ page, troubles, fetched }) => {
    const modules = () => fetched.filter((address) => new URL(address).pathname.endsWith('.wasm'));
    const libraries = () => fetched.filter((address) => /\/nxj-classes\.[^/]*bin$/.test(new URL(address).pathname));
    const program = 'public class Nothing {\n    public static void main(String[] args) {\n    }\n}\n';
    const runJava = () => page.evaluate((text) => globalThis.robotran.run(text, 1000, 'Nothing.java'), program);

    await page.evaluate(() => globalThis.robotran.run('beep', 1000));
    const before = new Set(modules());
    await runJava();
    // Bundling renames ecj.wasm.
    const compilers = modules().filter((address) => !before.has(address));
    assert.equal(compilers.length, 1);
    await runJava();
    assert.equal(modules().filter((address) => address === compilers[0]).length, 1);

    assert.deepEqual(libraries(), []);
    const forNxt = 'public class Hello {\n    public static void main(String[] args) {\n        System.out.println();\n    }\n}\n';
    for (let again = 0; again < 2; again++)
      await page.evaluate((text) => globalThis.robotran.run(text, 1000, 'Hello.java'), forNxt);
    assert.equal(libraries().length, 1, libraries().join());
    assert.deepEqual(troubles, []);
  }));
