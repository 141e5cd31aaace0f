// Says honestly what is the matter where the app cannot start, instead of leaving an empty page.
(() => {
  const say = (words) => {
    const place = document.getElementById('loading');
    if (place) place.textContent = words;
  };
  const OLD_BROWSER = 'This browser is too old for Robotran. Please use a newer Chrome, Edge, Firefox or Safari.';
  const NOT_STARTED = 'Robotran could not start. Please reload the page.';

  // A struct type and nothing else: only a browser with Wasm GC takes it for valid.
  const structType = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 95, 1, 127, 0]);
  const hasWasmGc = typeof WebAssembly === 'object' && WebAssembly.validate(structType);

  addEventListener('DOMContentLoaded', () => {
    if (!hasWasmGc) say(OLD_BROWSER);
  });
  addEventListener('error', () => say(hasWasmGc ? NOT_STARTED : OLD_BROWSER), true);
  addEventListener('unhandledrejection', () => say(hasWasmGc ? NOT_STARTED : OLD_BROWSER));
})();
