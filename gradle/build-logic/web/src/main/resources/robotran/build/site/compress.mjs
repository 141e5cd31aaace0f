// Writes NAME.br and NAME.gz beside each file of the folder TO that becomes smaller by it, at the highest levels.
// usage: node compress.mjs TO FROM   where FROM holds compressed files of an earlier time, whose names contain a hash
import { copyFile, readdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';

const [to, from] = process.argv.slice(2);
const COMPRESSIBLE = /\.(bin|css|html|js|svg|ttf|txt|wasm|webmanifest)$/;
const HASHED = /\.[0-9a-f]{16}\.\w+$/;
const LEAST_BYTES = 512;

const methods = {
  br: (bytes) =>
    promisify(brotliCompress)(bytes, {
      params: {
        [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
        [constants.BROTLI_PARAM_LGWIN]: constants.BROTLI_MAX_WINDOW_BITS,
        [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
      },
    }),
  gz: (bytes) => promisify(gzip)(bytes, { level: constants.Z_BEST_COMPRESSION }),
};

async function compress(name, ending) {
  const file = path.join(to, name);
  if (HASHED.test(name)) {
    const earlier = path.join(from, `${name}.${ending}`);
    if (await copyFile(earlier, `${file}.${ending}`).then(() => true, () => false)) return;
  }
  const bytes = await readFile(file);
  if (bytes.length < LEAST_BYTES) return;
  const smaller = await methods[ending](bytes);
  if (smaller.length < bytes.length) await writeFile(`${file}.${ending}`, smaller);
}

const names = (await readdir(to, { recursive: true })).filter((name) => COMPRESSIBLE.test(name)).sort();
// Node's compression runs in threads.
await Promise.all(names.flatMap((name) => Object.keys(methods).map((ending) => compress(name, ending))));
