// Caches the whole app in the browser, so that it works offline, and never mixes two versions.
//
// Each version has its own cache, which is filled completely before this worker takes over. From then on each new or
// reloaded page gets this version from its cache. An open page continues with its own version: file names contain
// content hashes, and the cache of its version is kept while the page holds the lock of that name. This worker also
// looks in those caches.
const VERSION = '{{version}}';
// The relative URL and SHA-256 of each file. The page itself is the empty URL.
const FILES = {{files}};

const SCOPE = new URL('./', self.location.href);
const PREFIX = `robotran ${SCOPE.pathname} `;
const CACHE = PREFIX + VERSION;

const absolute = (address) => new URL(address, SCOPE).href;

/** Fetches a file and checks its hash. A partial upload, a broken download or a captive portal's page is an error. */
async function fetchExactly(address, integrity) {
  // File names contain content hashes, so a response from the browser's cache is valid unless it is corrupt.
  const caches = address.startsWith('files/') ? ['default', 'reload'] : ['reload'];
  for (const cache of caches) {
    const response = await fetch(absolute(address), { cache, integrity }).catch(() => null);
    // A redirected response cannot be used for a page.
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

/** Fills the cache and resumes an interrupted attempt. One file at a time, so that the open page gets the bandwidth. */
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
    // If storage is short, the pupil's project has priority.
    if (error.name === 'QuotaExceededError') await caches.delete(CACHE);
    throw error;
  }
  await self.skipWaiting();
}

/** Deletes the caches of versions that no page runs. */
async function tidyUp() {
  if (self.registration.installing || self.registration.waiting || !self.navigator.locks) return;
  const { held } = await self.navigator.locks.query();
  const running = held.map(({ name }) => name).filter((name) => name.startsWith(PREFIX));
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  // A page that is just opening may not hold its version's lock yet.
  if (pages.filter(({ url }) => url.startsWith(SCOPE.href)).length > running.length) return;
  for (const name of await ownCaches()) {
    if (name !== CACHE && !running.includes(name)) await caches.delete(name);
  }
}

async function answer(request, address) {
  const kept = (await foundIn([CACHE], address)) ?? (await foundIn(await ownCaches(), address));
  return kept ?? fetch(request);
}

/** The page of this version, or else from the network, but never an older one. */
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
