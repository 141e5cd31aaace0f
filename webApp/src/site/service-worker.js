// Keeps the whole app in the browser, so that it opens without a network, and never mixes two versions of it.
//
// Each version has a cache of its own, filled completely before this worker takes over. From then on whoever opens or
// reloads the page gets this version, from its cache. A page that is open goes on with the version it began with: what
// is in a file is in its name, its own version's cache is kept as long as it holds a lock of that name, and this worker
// looks there, too.
const VERSION = '{{version}}';
// Address and SHA-256 of each file, relative to this one; the page itself is the empty address.
const FILES = {{files}};

const SCOPE = new URL('./', self.location.href);
const PREFIX = `robotran ${SCOPE.pathname} `;
const CACHE = PREFIX + VERSION;

const absolute = (address) => new URL(address, SCOPE).href;

/** A file as it has to be; a half uploaded site, a broken download or a network's own page in its place is an error. */
async function fetchExactly(address, integrity) {
  // What is in a file is in its name, so that one of the browser's own cache will do, unless it is broken.
  const caches = address.startsWith('files/') ? ['default', 'reload'] : ['reload'];
  for (const cache of caches) {
    const response = await fetch(absolute(address), { cache, integrity }).catch(() => null);
    // One that was redirected may not answer for a page.
    if (response && response.ok) return new Response(response.body, { headers: response.headers });
  }
  throw new Error(`${address} could not be fetched`);
}

async function foundIn(names, address) {
  for (const name of names) {
    const response = await (await caches.open(name)).match(address, { ignoreVary: true });
    if (response) return response;
  }
  return null;
}

const ownCaches = async () => (await caches.keys()).filter((name) => name.startsWith(PREFIX));

/**
 * Fills the cache, going on where an earlier attempt broke off. One file at a time, so that the open page has the
 * network to itself.
 */
async function fill() {
  const others = (await ownCaches()).filter((name) => name !== CACHE);
  const cache = await caches.open(CACHE);
  for (const [address, integrity] of FILES) {
    const whole = absolute(address);
    if (await cache.match(whole)) continue;
    const known = address.startsWith('files/') ? await foundIn(others, whole) : null;
    await cache.put(whole, known ?? (await fetchExactly(address, integrity)));
  }
}

async function install() {
  try {
    await fill();
  } catch (error) {
    // Room that is short belongs to the pupil's work.
    if (error.name === 'QuotaExceededError') await caches.delete(CACHE);
    throw error;
  }
  await self.skipWaiting();
}

/** Lets go of versions that no page runs any more. */
async function tidyUp() {
  if (self.registration.installing || self.registration.waiting || !self.navigator.locks) return;
  const { held } = await self.navigator.locks.query();
  const running = held.map(({ name }) => name).filter((name) => name.startsWith(PREFIX));
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  // A page that is just being opened has not said yet what it runs.
  if (pages.filter(({ url }) => url.startsWith(SCOPE.href)).length > running.length) return;
  for (const name of await ownCaches()) {
    if (name !== CACHE && !running.includes(name)) await caches.delete(name);
  }
}

async function answer(request, address) {
  const kept = (await foundIn([CACHE], address)) ?? (await foundIn(await ownCaches(), address));
  return kept ?? fetch(request);
}

/** The page as it is in this version, or else from the network, but never that of an older one. */
const answerWithPage = async (request) => (await foundIn([CACHE], absolute(''))) ?? fetch(request);

self.addEventListener('install', (event) => event.waitUntil(install()));
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
self.addEventListener('message', (event) => event.waitUntil(tidyUp()));
self.addEventListener('fetch', (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (request.method !== 'GET' || !url.href.startsWith(SCOPE.href)) return;
  const address = url.pathname.slice(SCOPE.pathname.length);
  if (request.mode === 'navigate') {
    if (address === '' || address === 'index.html') event.respondWith(answerWithPage(request));
  } else if (address.startsWith('files/') || address === 'manifest.webmanifest') {
    event.respondWith(answer(request, absolute(address)));
  }
});
