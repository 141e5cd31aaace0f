// What the content security policy of the page forbids.

/** Runs in the page: records policy violations. */
export function watch() {
  globalThis.violations = [];
  addEventListener(
    'securitypolicyviolation',
    ({ violatedDirective, blockedURI, sourceFile, lineNumber }) =>
      globalThis.violations.push(`${violatedDirective} ${blockedURI} ${sourceFile}:${lineNumber}`),
    true,
  );
}

export const violations = (page) => page.evaluate(() => globalThis.violations);
