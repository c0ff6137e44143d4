// Keeps the page's own files, so that it opens without a network after the first visit. A new version is loaded while the
// old one is used, and shown when all windows of the old one are closed.

const OURS = `texplorer ${self.registration.scope} `; // other folders of the server have caches of their own
const VERSION = `${OURS}@VERSION@`;
const FILES = @FILES@;

// A redirected response would be refused as the answer to a navigation.
async function keep(cache, file) {
    const response = await fetch(file, { cache: 'reload' });
    if (!response.ok)
        throw new Error(`${file}: ${response.status}`);
    await cache.put(file, response.redirected ? new Response(response.body, { headers: response.headers }) : response);
}

self.addEventListener('install', (event) => {
    event.waitUntil(caches.open(VERSION).then((cache) => Promise.all(FILES.map((file) => keep(cache, file)))));
});

self.addEventListener('activate', (event) => {
    event.waitUntil(caches.keys().then((names) => Promise.all(
        names.filter((name) => name.startsWith(OURS) && name !== VERSION).map((name) => caches.delete(name)))));
});

self.addEventListener('fetch', (event) => {
    event.respondWith(caches.open(VERSION).then((cache) => cache.match(event.request, { ignoreSearch: true, ignoreVary: true }))
        .then((kept) => kept ?? fetch(event.request)));
});
