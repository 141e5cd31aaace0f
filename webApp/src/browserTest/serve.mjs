// Serves the built page on localhost, with the headers that docs/hosting.md requires.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ttf': 'font/ttf',
};

const NEVER_CHANGES = 'public, max-age=31536000, immutable';

/** Precompressed with Brotli, as on a host; each file once. */
const compressed = new Map();
function compress(file, bytes) {
  if (!compressed.has(file))
    compressed.set(file, brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 9 } }));
  return compressed.get(file);
}

/**
 * Serves the folder on a free port, or at the path `under` of it. Returns the address, the requests so far, and
 * functions to change the folder, to fail and to stop. `refuse` gets the path of a request and returns a status that
 * replaces the response, or null.
 */
export async function serve(folder, { under = '/', compresses = false, headers = {}, refuse = () => null } = {}) {
  const site = { folder, refuse, asked: [] };
  const server = createServer(async (request, response) => {
    const asked = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    const inside = asked.startsWith(under) ? asked.slice(under.length) : null;
    site.asked.push(asked);
    const refusal = site.refuse(asked);
    try {
      if (refusal !== null || inside === null) throw new Error('refused');
      const file = path.join(
        site.folder,
        path.normalize(inside === '' || inside.endsWith('/') ? `${inside}index.html` : inside),
      );
      const bytes = await readFile(file);
      const fits = compresses && /br/.test(request.headers['accept-encoding'] ?? '') && !/\.png$/.test(file);
      response.writeHead(200, {
        'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream',
        'cache-control': inside.startsWith('files/') ? NEVER_CHANGES : 'no-cache',
        'x-content-type-options': 'nosniff',
        ...(fits ? { 'content-encoding': 'br' } : {}),
        ...headers,
      });
      response.end(fits ? compress(file, bytes) : bytes);
    } catch {
      response.writeHead(refusal ?? 404);
      response.end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  site.address = `http://127.0.0.1:${server.address().port}${under}`;
  site.stop = () => {
    server.close();
    server.closeAllConnections();
  };
  return site;
}
