// What the build adds to the site for servers that send compressed files.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { brotliDecompressSync, gunzipSync } from 'node:zlib';

const SCRIPT = '../../../../gradle/build-logic/web/src/main/resources/robotran/build/site/compress.mjs';
const script = fileURLToPath(new URL(SCRIPT, import.meta.url));
const text = 'forward 10\nright 90\n'.repeat(100);
const HASHED = 'app.0123456789abcdef.js';

async function folders(t) {
  const root = await mkdtemp(path.join(tmpdir(), 'robotran-compress-'));
  t.after(() => rm(root, { recursive: true }));
  const [site, earlier] = [path.join(root, 'site'), path.join(root, 'earlier')];
  await mkdir(path.join(site, 'files'), { recursive: true });
  return { site, earlier };
}

test('compressed files hold the same bytes; small files and pictures get none', async (t) => {
  const { site, earlier } = await folders(t);
  await writeFile(path.join(site, 'index.html'), text);
  await writeFile(path.join(site, 'files', HASHED), text);
  await writeFile(path.join(site, 'files', 'small.js'), 'x');
  await writeFile(path.join(site, 'files', 'icon.png'), text);
  execFileSync(process.execPath, [script, site, earlier]);
  assert.deepEqual((await readdir(site, { recursive: true })).sort(), [
    'files',
    `files/${HASHED}`,
    `files/${HASHED}.br`,
    `files/${HASHED}.gz`,
    'files/icon.png',
    'files/small.js',
    'index.html',
    'index.html.br',
    'index.html.gz',
  ]);
  assert.equal(String(brotliDecompressSync(await readFile(path.join(site, 'index.html.br')))), text);
  assert.equal(String(gunzipSync(await readFile(path.join(site, 'files', `${HASHED}.gz`)))), text);
});

test('a file whose name holds the hash of its content is compressed once', async (t) => {
  const { site, earlier } = await folders(t);
  await mkdir(path.join(earlier, 'files'), { recursive: true });
  await writeFile(path.join(earlier, 'files', `${HASHED}.br`), 'of the build before');
  await writeFile(path.join(earlier, 'index.html.br'), 'of the build before');
  await writeFile(path.join(site, 'index.html'), text);
  await writeFile(path.join(site, 'files', HASHED), text);
  execFileSync(process.execPath, [script, site, earlier]);
  assert.equal(String(await readFile(path.join(site, 'files', `${HASHED}.br`))), 'of the build before');
  assert.equal(String(brotliDecompressSync(await readFile(path.join(site, 'index.html.br')))), text);
});
