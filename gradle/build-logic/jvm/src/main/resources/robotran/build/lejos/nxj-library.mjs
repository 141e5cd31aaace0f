/*
 * Fetches the class library of an NXT, whose files are next to this one. Works in browsers, bundled or not, and in Node.
 */

/** Returns the packed class files as an Int8Array. */
export function classes() {
  return bytesOf(new URL('./nxj-classes.bin', import.meta.url));
}

/** Returns the packed sources as an Int8Array. */
export function sources() {
  return bytesOf(new URL('./nxj-sources.bin', import.meta.url));
}

async function bytesOf(location) {
  if (location.protocol === 'file:' && globalThis.process?.versions?.node) {
    const { readFile } = await import(/* webpackIgnore: true */ 'node:fs/promises');
    return new Int8Array(await readFile(location));
  }
  const response = await fetch(location);
  if (!response.ok) throw new Error(`${location} could not be loaded: ${response.status}`);
  return new Int8Array(await response.arrayBuffer());
}
