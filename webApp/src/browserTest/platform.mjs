// A small stand-in for a learning platform: it unpacks a SCORM package and shows an item of it in a frame.
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { inflateRawSync } from 'node:zlib';

const DIRECTORY_END = 0x06054b50;
const DEFLATED = 8;

/** Unpacks the zip file `zip` into `folder`, and returns the paths in it. */
export async function unpack(zip, folder) {
  const bytes = await readFile(zip);
  let end = bytes.length - 22;
  while (bytes.readUInt32LE(end) !== DIRECTORY_END) end--;
  const paths = [];
  let place = bytes.readUInt32LE(end + 16);
  for (let count = bytes.readUInt16LE(end + 10); count > 0; count--) {
    const [method, packed] = [bytes.readUInt16LE(place + 10), bytes.readUInt32LE(place + 20)];
    const [name, extra, comment] = [28, 30, 32].map((offset) => bytes.readUInt16LE(place + offset));
    const local = bytes.readUInt32LE(place + 42);
    const file = bytes.toString('utf8', place + 46, place + 46 + name);
    const start = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    const content = bytes.subarray(start, start + packed);
    const target = path.join(folder, path.normalize(file));
    await mkdir(path.dirname(target), { recursive: true });
    await writeFile(target, method === DEFLATED ? inflateRawSync(content) : content);
    paths.push(file);
    place += 46 + name + extra + comment;
  }
  return paths;
}

/**
 * The page of the platform around the item `item`. It offers the API of the standard `version`, 1.2 or 2004, keeps what
 * is set, and begins with `values`.
 */
export const platformPage = (version, item, values = {}) => {
  const is12 = version === '1.2';
  const name = (word) => (is12 ? `LMS${word}` : word);
  const api = `{
      ${name('Initialize')}: () => { calls.push('begin'); return 'true'; },
      ${name('GetValue')}: (key) => values[key] ?? '',
      ${name('SetValue')}: (key, value) => { values[key] = value; return 'true'; },
      ${name('Commit')}: () => { calls.push('save'); return 'true'; },
      ${is12 ? 'LMSFinish' : 'Terminate'}: () => { calls.push('end'); return 'true'; },
    }`;
  return `<!DOCTYPE html>
<html lang="en"><head><title>Platform</title>
<style>html, body, iframe { margin: 0; border: 0; width: 100%; height: 100%; display: block }</style></head>
<body><script>
  const calls = [];
  const values = ${JSON.stringify(values)};
  globalThis.${is12 ? 'API' : 'API_1484_11'} = ${api};
</script><iframe title="Item" src="${item}"></iframe></body></html>`;
};
