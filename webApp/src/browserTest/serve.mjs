// Serves the built page on localhost, with the headers that docs/hosting.md requires.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import path from 'node:path';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ttf': 'font/ttf',
};

/** A page of the site's origin with nothing in it, not even the wish for an icon. */
export const EMPTY = 'empty.html';

const NEVER_CHANGES = 'public, max-age=31536000, immutable';

/** The file compressed with Brotli by the build, null if there is none. */
const compressed = (file) => readFile(`${file}.br`).catch(() => null);

/**
 * Serves the folder on a free port, or at the path `under` of it. Returns the address, the requests so far, and
 * functions to change the folder, to fail and to stop. `refuse` gets the path of a request and returns a status that
 * replaces the response, or null, or a promise of one, for which the answer waits. `pages` has texts that are served in place of files, by their path.
 */
export async function serve(folder, { under = '/', compresses = false, headers = {}, refuse = () => null } = {}) {
  const site = { folder, refuse, asked: [], pages: {} };
  const server = createServer(async (request, response) => {
    const asked = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    const inside = asked.startsWith(under) ? asked.slice(under.length) : null;
    site.asked.push(asked);
    const refusal = await site.refuse(asked);
    try {
      if (refusal !== null || inside === null) throw new Error('refused');
      const file = path.join(
        site.folder,
        path.normalize(inside === '' || inside.endsWith('/') ? `${inside}index.html` : inside),
      );
      const bytes = site.pages[inside] ?? (inside === EMPTY ? '<link rel="icon" href="data:,">' : await readFile(file));
      const fits = compresses && /br/.test(request.headers['accept-encoding'] ?? '');
      const smaller = fits ? await compressed(file) : null;
      response.writeHead(200, {
        'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream',
        'cache-control': inside.startsWith('files/') ? NEVER_CHANGES : 'no-cache',
        'x-content-type-options': 'nosniff',
        ...(smaller ? { 'content-encoding': 'br' } : {}),
        ...headers,
      });
      response.end(smaller ?? bytes);
    } catch {
      response.writeHead(refusal ?? 404);
      response.end();
    }
  });
  // A browser that asks over a connection just when it is closed gets nothing.
  server.keepAliveTimeout = 0;
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  site.address = `http://127.0.0.1:${server.address().port}${under}`;
  site.stop = () => {
    server.close();
    server.closeAllConnections();
  };
  return site;
}
