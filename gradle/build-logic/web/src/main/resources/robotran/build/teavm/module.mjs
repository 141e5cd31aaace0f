import { load } from './NAME-runtime.mjs';

let loading = null;

/**
 * Returns the exported functions once the WebAssembly module next to this file is loaded. All calls share one load, but
 * a failed one is retried. Works in browsers, bundled or not, and in Node.
 */
export async function loadModule() {
  return (await loaded()).exports;
}

function loaded() {
  loading ??= fresh().catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

async function fresh() {
  return load(await bytesOf(new URL('./NAME.wasm', import.meta.url)), {});
}

/* Loads all bytes before compiling: streaming would need a server that sends the MIME type of wasm files. */
async function bytesOf(location) {
  if (location.protocol === 'file:' && globalThis.process?.versions?.node) {
    const { readFile } = await import(/* webpackIgnore: true */ 'node:fs/promises');
    return readFile(location);
  }
  const response = await fetch(location);
  if (!response.ok) throw new Error(`${location} could not be loaded: ${response.status}`);
  return response.arrayBuffer();
}
