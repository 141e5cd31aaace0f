import { load } from './NAME-runtime.mjs';

let loading = null;

/**
 * The exported functions, once the WebAssembly module beside this file is loaded: fetched at the first call and the
 * same for all later ones, unless it could not be fetched. Works in browsers, bundled or not, and in Node.
 */
export function loadModule() {
  loading ??= fresh().catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}

async function fresh() {
  const module = await load(await bytesOf(new URL('./NAME.wasm', import.meta.url)), {});
  return module.exports;
}

/* All the bytes at once, since compiling as they stream in would need a server that knows the type of wasm files. */
async function bytesOf(location) {
  if (location.protocol === 'file:' && globalThis.process?.versions?.node) {
    const { readFile } = await import(/* webpackIgnore: true */ 'node:fs/promises');
    return readFile(location);
  }
  const response = await fetch(location);
  if (!response.ok) throw new Error(`${location} could not be loaded: ${response.status}`);
  return response.arrayBuffer();
}
