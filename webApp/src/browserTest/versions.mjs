// Another version of the built site, as an update would create it.
import { createHash } from 'node:crypto';
import { cp, mkdtemp, readdir, readFile, rename, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';

const NAMED_BY_CONTENT = /\.([0-9a-f]{16})\.\w+$/;
const TEXTS = /\.(js|html)$/;

/**
 * Copies the site and renames every file in `files`, as if each had changed. Returns the new folder, which the caller
 * must delete.
 */
export async function anotherVersion(folder) {
  const copy = await mkdtemp(path.join(os.tmpdir(), 'robotran-site-'));
  await cp(folder, copy, { recursive: true });
  const files = path.join(copy, 'files');
  const hashes = (await readdir(files)).map((name) => NAMED_BY_CONTENT.exec(name)?.[1]).filter(Boolean);
  const renamed = (text) =>
    hashes.reduce((changed, hash) => changed.replaceAll(hash, [...hash].reverse().join('')), text);
  for (const name of await readdir(files)) {
    const file = path.join(files, name);
    if (TEXTS.test(name)) await writeFile(file, renamed(await readFile(file, 'utf8')));
    await rename(file, path.join(files, renamed(name)));
  }
  const html = await readFile(path.join(copy, 'index.html'), 'utf8');
  const version = /"version":"(\w+)"/.exec(html)[1];
  const changedVersion = (text) => renamed(text).replaceAll(version, [...version].reverse().join(''));
  await writeFile(path.join(copy, 'index.html'), changedVersion(html));
  const manifest = path.join(copy, 'manifest.webmanifest');
  await writeFile(manifest, renamed(await readFile(manifest, 'utf8')));

  const worker = path.join(copy, 'service-worker.js');
  const text = changedVersion(await readFile(worker, 'utf8'));
  const list = /^const FILES = (.*);$/m.exec(text)[1];
  const measured = await Promise.all(
    JSON.parse(list).map(async ([address]) => {
      const bytes = await readFile(path.join(copy, address || 'index.html'));
      return [address, `sha256-${createHash('sha256').update(bytes).digest('base64')}`];
    }),
  );
  await writeFile(worker, text.replace(list, JSON.stringify(measured)));
  return copy;
}
