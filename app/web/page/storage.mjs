// The program's files: a file system in memory. What it keeps (settings, recent files, unsaved work) and what the user has
// given it is stored in IndexedDB after every change, so that it survives the page.

import { Directory, File, OpenDirectory, PreopenDirectory } from './wasi/index.js';

const DATABASE = `texplorer ${new URL('.', import.meta.url).pathname}`; // each folder of a server has its own
const STORE = 'files';
const RETRY = 5000; // milliseconds
const LEAVING = 300; // milliseconds
const GONE = Symbol('to be removed');
const SHARED = /^\/home\/(config|state\/texplorer\/[^/]*$)/; // by all pages; the rest belongs to one page
const ROOTS = ['home', 'given'];

const now = () => BigInt(Date.now()) * 1000000n;

// Files know when they were written, and have one name.
const plainStat = File.prototype.stat;
File.prototype.stat = function stat() {
    if (this.dated !== this.data) { // what makes it longer or shorter makes another array
        this.dated = this.data;
        this.written = now();
    }
    return Object.assign(plainStat.call(this), { mtim: this.written, nlink: 1n });
};

// The program may write in every folder: what it asks for is what the files of a folder inherit.
const plainFdstat = OpenDirectory.prototype.fd_fdstat_get;
OpenDirectory.prototype.fd_fdstat_get = function fdstat() {
    const answer = plainFdstat.call(this);
    answer.fdstat.fs_rights_inherited = 0xffffffffffffffffn;
    return answer;
};

// The times of a file stand behind its size, 8 bytes each; the library writes them in other places.
const Filestat = Object.getPrototypeOf(plainStat.call(new File([])));
const plainWrite = Filestat.write_bytes;
Filestat.write_bytes = function writeBytes(view, at) {
    plainWrite.call(this, view, at);
    [this.atim, this.mtim, this.ctim].forEach((time, i) => view.setBigUint64(at + 40 + 8 * i, time, true));
};

function folderOf(root, path, make) {
    let folder = root;
    for (const name of path.split('/').filter(Boolean).slice(0, -1)) {
        let next = folder.contents.get(name);
        if (!next && make) {
            next = new Directory(new Map());
            next.parent = folder;
            folder.contents.set(name, next);
        }
        if (!(next instanceof Directory))
            return null;
        folder = next;
    }
    return folder;
}

const nameOf = (path) => path.slice(path.lastIndexOf('/') + 1);

function* filesBelow(folder, path) {
    for (const [name, entry] of folder.contents) {
        if (entry instanceof Directory)
            yield* filesBelow(entry, `${path}/${name}`);
        else
            yield [`${path}/${name}`, entry];
    }
}

const done = (request) => new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
});
const ended = (transaction) => new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onerror = () => reject(transaction.error);
    transaction.onabort = () => reject(transaction.error);
});

async function openDatabase() {
    const request = indexedDB.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    return done(request);
}

// The names of all locks of this folder's pages.
async function openPages() {
    const { held } = await navigator.locks.query();
    return new Set(held.map((lock) => lock.name).filter((name) => name.startsWith(`${DATABASE}:`)));
}

export class Storage {
    root = new PreopenDirectory('/', new Map());
    #page = [...crypto.getRandomValues(new Uint32Array(4))].join('-'); // randomUUID needs https
    #database = null;
    #stored = new Map(); // path → the content that is stored or being stored
    #pending = Promise.resolve(); // the transactions, in their order
    #failed; // called with an error, once until storing works again
    #isFailing = false;
    #pages;

    // `failed` is called with a reason when nothing can be kept.
    constructor(failed) {
        this.#failed = failed;
        for (const folder of [...ROOTS, 'downloads', 'tmp'])
            folderOf(this.root.dir, `/${folder}/`, true) ??
                this.root.dir.contents.set(folder, new Directory(new Map()));
        for (const folder of ['/home/state/texplorer/x', '/home/config/texplorer/x', '/given/x', '/downloads/x', '/tmp/x'])
            folderOf(this.root.dir, folder, true);
    }

    write(path, bytes, written) {
        const file = new File(bytes);
        if (written !== undefined)
            Object.assign(file, { dated: file.data, written });
        folderOf(this.root.dir, path, true).contents.set(nameOf(path), file);
    }

    // The paths and contents of all files.
    files() { return [...filesBelow(this.root.dir, '')].map(([path, file]) => [path, file.data]); }

    // Reads what earlier pages have kept. The unsaved work of a page that is still open stays with it.
    async open() {
        try {
            if (!navigator.locks)
                throw new Error('the page needs https to store anything');
            this.#pages = new BroadcastChannel(DATABASE); // first: what others write meanwhile is heard
            this.#pages.onmessage = ({ data }) => {
                this.write(data.path, data.bytes);
                this.#stored.set(data.path, this.#find(data.path).data);
            };
            this.#database = await openDatabase();
            await this.#hold();
            await navigator.locks.request(`${DATABASE}:adopt`, () => this.#adopt());
        } catch (error) {
            this.#database = null;
            this.#fail(error);
        }
    }

    // A lock that ends with the page: others see whether it is open.
    #hold() {
        return new Promise((resolve, reject) => {
            navigator.locks.request(`${DATABASE}:${this.#page}`, () => {
                resolve();
                return new Promise(() => {});
            }).catch(reject);
        });
    }

    async #adopt() {
        let open = await openPages();
        if (open.size > 2) { // of this page, and of this work: the lock of a page that was just left ends a little later
            await new Promise((resolve) => { setTimeout(resolve, LEAVING); });
            open = await openPages();
        }
        const transaction = this.#database.transaction(STORE, 'readwrite');
        const store = transaction.objectStore(STORE);
        const [keys, values] = await Promise.all([done(store.getAllKeys()), done(store.getAll())]);
        const files = values.map((value, i) => ({ key: keys[i], ...value }));
        const pageOf = ({ key }) => key.slice(0, key.indexOf('/'));
        const drafts = files.filter((file) => !SHARED.test(file.path) && !open.has(`${DATABASE}:${pageOf(file)}`) &&
            /\/unsaved\/.*\.scene$/.test(file.path));
        const newest = drafts.reduce((best, each) => (best && best.written >= each.written ? best : each), null);
        const waiting = new Set(drafts.map(pageOf)); // of several, the others are offered at later starts
        for (const file of files) {
            const { key, path, bytes, written } = file;
            const isNewest = newest !== null && pageOf(file) === pageOf(newest);
            if (!SHARED.test(path) && !isNewest) {
                if (!open.has(`${DATABASE}:${pageOf(file)}`) && !waiting.has(pageOf(file)))
                    store.delete(key); // no draft names it
                continue;
            }
            this.write(path, bytes, written);
            this.#stored.set(path, this.#find(path).data);
            if (!SHARED.test(path)) {
                store.delete(key);
                store.put({ path, bytes, written }, this.#keyOf(path));
            }
        }
        await ended(transaction);
    }


    #find(path) { return folderOf(this.root.dir, path, false)?.contents.get(nameOf(path)); }
    #keyOf(path) { return SHARED.test(path) ? path : this.#page + path; }

    // Stores what has changed. Cheap if nothing has.
    keep() {
        const changes = [];
        const present = new Set();
        for (const root of ROOTS) {
            for (const [path, file] of filesBelow(this.root.dir.contents.get(root), `/${root}`)) {
                present.add(path);
                if (path.endsWith('.lock') || this.#stored.get(path) === file.data)
                    continue;
                this.#stored.set(path, file.data);
                changes.push({ path, bytes: file.data.slice() });
            }
        }
        for (const path of this.#stored.keys()) {
            if (!present.has(path)) {
                this.#stored.delete(path);
                changes.push({ path });
            }
        }
        if (changes.length > 0 && this.#database)
            this.#pending = this.#pending.then(() => this.#store(changes)).catch((error) => {
                for (const { path, bytes } of changes) // again with the next change, or after a while
                    this.#stored.set(path, bytes ? null : GONE);
                setTimeout(() => this.keep(), RETRY);
                this.#fail(error);
            });
    }

    async #store(changes) {
        const transaction = this.#database.transaction(STORE, 'readwrite');
        const store = transaction.objectStore(STORE);
        for (const { path, bytes } of changes) {
            if (bytes)
                store.put({ path, bytes, written: now() }, this.#keyOf(path));
            else
                store.delete(this.#keyOf(path));
        }
        await ended(transaction);
        this.#isFailing = false;
        for (const change of changes) {
            if (change.bytes && SHARED.test(change.path))
                this.#pages.postMessage(change);
        }
    }

    #fail(error) {
        if (!this.#isFailing)
            this.#failed(error);
        this.#isFailing = true;
    }

    // The files that the program has written for the user, once.
    takeDownloads() {
        const { contents } = this.root.dir.contents.get('downloads');
        const files = [...contents].map(([name, file]) => ({ name, bytes: file.data }));
        contents.clear();
        return files;
    }
}
