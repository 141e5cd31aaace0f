// Loads the app into a worker, where it has no page, draws nothing and grades hand-ins: see docs/web-page.md.
addEventListener(
  'message',
  ({ data: { scripts, app, module, rest, skiko } }) => {
    // The page has compiled all parts of the app's module. Skia, which the app imports, would be of no use here: its functions do
    // nothing, and none is called.
    const memory = new WebAssembly.Memory({ initial: 1 });
    const nothing = new Proxy({}, { get: (_, name) => (name === 'memory' ? memory : () => 0) });
    const answers = {
      [app]: async (imports) => {
        const instance = await WebAssembly.instantiate(module, imports);
        let known = { ...imports, first: instance.exports };
        for (const [name, piece] of rest) known = { ...known, [name]: (await WebAssembly.instantiate(piece, known)).exports };
        return { module, instance };
      },
      [skiko]: async () => ({ module, instance: { exports: nothing } }),
    };
    const fetchAsEver = globalThis.fetch;
    globalThis.fetch = async (input, options) => answers[input] ?? fetchAsEver(input, options);
    WebAssembly.instantiateStreaming = async (source, imports) => (await source)(imports);
    importScripts(...scripts);
  },
  { once: true },
);
