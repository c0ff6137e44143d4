// The program of a page without a browser: what it calls is recorded, its files are the page's own storage.

import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { webcrypto } from 'node:crypto';

const SIZE = [640, 400]; // small: most of a frame's time are the pixels of the scene
const MOST_FRAMES = 30; // that follow each other: an animation has no end
const BLOCK = 65536;
const AT_ONCE = 0.015; // seconds: the page does not wait for less

const FONTS = {
    'DejaVuSans.ttf': '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf',
    'DejaVuSansMono.ttf': '/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf',
    'DejaVuSans-Bold.ttf': '/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf',
    'Chinese.ttf': '/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf',
};

const encoder = new TextEncoder();
const decoder = new TextDecoder('utf-8', { fatal: true });

// A built page. Its modules are loaded from a copy: node takes .js for modules only where a package says so.
export class Page {
    static async load(folder) {
        const page = new Page();
        const copy = mkdtempSync(join(tmpdir(), 'texplorer-'));
        try {
            writeFileSync(join(copy, 'package.json'), '{ "type": "module" }');
            for (const name of ['windowless.mjs', 'storage.mjs', 'wasi'])
                cpSync(join(folder, name), join(copy, name), { recursive: true });
            const load = (name) => import(pathToFileURL(join(copy, name)));
            globalThis.crypto ??= webcrypto; // node 18 has none
            ({ Storage: page.Storage } = await load('storage.mjs'));
            ({ Windowless: page.Windowless } = await load('windowless.mjs'));
            ({ WASI: page.WASI, ConsoleStdout: page.ConsoleStdout } = await load('wasi/index.js'));
        } finally {
            rmSync(copy, { recursive: true });
        }
        page.module = await WebAssembly.compile(readFileSync(join(folder, 'texplorer.wasm')));
        page.fonts = Object.entries(FONTS).map(([name, path]) => [path, readFileSync(join(folder, 'fonts', name))]);
        return page;
    }
}

export class Program {
    calls = new Map(); // name of a function of the page → how often it was called
    spoken = null; // the last stage::Spoken
    posted = []; // messages to the page around this one, as texts
    saved = []; // files for the user
    copied = null; // the clipboard's text
    log = []; // lines that were written to the console
    workers = new Map(); // number → what draws, as a Web Worker does
    asked = []; // what they were asked, newest last, each a function that draws and gives the answer to the program
    pictures = []; // their answers
    shares = []; // of files, as they told them
    milliseconds = 0; // how long each seems to take
    #exports;
    #Windowless;
    #withoutWorkers;

    // `storage` is that of a program before: the page is opened again.
    constructor(page, { language = 'en', storage, size = SIZE, withoutWorkers = false } = {}) {
        this.#withoutWorkers = withoutWorkers;
        this.#Windowless = page.Windowless;
        this.storage = storage ?? new page.Storage((error) => { throw error; });
        for (const [path, font] of page.fonts)
            this.storage.write(path, font);
        const log = page.ConsoleStdout.lineBuffered((line) => this.log.push(line));
        const wasi = new page.WASI([], ['HOME=/home', 'XDG_STATE_HOME=/home/state', 'XDG_CONFIG_HOME=/home/config',
            `LANG=${language}.UTF-8`], [log, log, log, this.storage.root], { debug: false });
        const instance = new WebAssembly.Instance(page.module,
            { wasi_snapshot_preview1: wasi.wasiImport, browser: this.#browser(page.module) });
        this.#exports = instance.exports;
        wasi.initialize(instance);
        this.call('start', ...size, ...size, 1, false, ...this.copyIn('https://example.org/'));
    }

    // A function for each that the program names, so that a new one needs no change here.
    #browser(module) {
        let made = 0;
        const known = {
            maxTextureSize: () => 8192,
            makeWorker: () => {
                if (this.#withoutWorkers)
                    return 0;
                this.workers.set(++made, new this.#Windowless(module));
                return made;
            },
            makeFileInCopy: (order) => {
                if (this.#withoutWorkers)
                    return 0;
                const copy = { memory: this.#exports.memory.buffer.slice(0), files: this.storage.files() };
                const worker = ++made;
                const program = new this.#Windowless(module, copy, (share) => this.shares.push(share));
                this.workers.set(worker, program);
                this.asked.push(() => this.#fileOf(worker, order));
                return worker;
            },
            dropWorker: (worker) => { this.workers.delete(worker); },
            sendFile: (worker, name, nameLength, at, length) =>
                this.workers.get(worker).setFile(this.#textAt(name, nameLength), length < 0 ? null : this.#bytesAt(at, length)),
            drawInWorker: (worker, at, length, ...numbers) => {
                const scene = this.#textAt(at, length);
                this.asked.push(() => this.#answerOf(worker, scene, numbers));
            },
            speak: (at, length) => { this.spoken = JSON.parse(this.#textAt(at, length)); },
            postMessage: (at, length) => { this.posted.push(this.#textAt(at, length)); },
            saveFile: (name, nameLength, at, length) =>
                this.saved.push({ name: this.#textAt(name, nameLength), bytes: this.#bytesAt(at, length) }),
            writeClipboard: (at, length) => { this.copied = this.#textAt(at, length); },
        };
        const browser = {};
        for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
            if (from !== 'browser' || kind !== 'function')
                continue;
            const act = known[name] ?? (name.startsWith('make') ? () => ++made : () => 0);
            browser[name] = (...values) => {
                this.calls.set(name, this.count(name) + 1);
                return act(...values);
            };
        }
        return browser;
    }

    count(name) { return this.calls.get(name) ?? 0; }
    get memory() { return this.#exports.memory.buffer.byteLength; }

    // The bytes in use: what can't be taken without more memory. The memory itself says little, for much of it is free.
    get used() {
        const before = this.memory;
        const taken = [];
        while (this.memory === before)
            taken.push(this.call('allocate', BLOCK));
        for (const at of taken)
            this.call('clipboardChanged', at, 0); // frees it
        return before - (taken.length - 1) * BLOCK;
    }

    #bytesAt(at, length) { return new Uint8Array(this.#exports.memory.buffer).slice(at, at + length); }
    #textAt(at, length) { return decoder.decode(this.#bytesAt(at, length)); }

    // An answer of a worker that was dropped does not arrive.
    #answerOf(worker, scene, values) {
        const drawer = this.workers.get(worker);
        if (!drawer)
            return;
        const { pixels, width, height, problems } = drawer.draw(scene, ...values);
        this.pictures.push({ pixels, width, height, problems: JSON.parse(problems) });
        this.call('takePicture', worker, ...this.copyIn(pixels), width, height,
            this.milliseconds, ...this.copyIn(problems));
    }

    #fileOf(worker, order) {
        const program = this.workers.get(worker);
        if (!program)
            return;
        const { made, file, sentences } = program.makeFile(order);
        for (const share of this.shares)
            this.call('fileProgress', worker, share);
        this.call('takeFile', worker, made, ...this.copyIn(file), ...this.copyIn(sentences));
    }

    // Lets the workers do all that they are asked.
    wait() {
        while (this.asked.length > 0) {
            this.asked.shift()();
            this.draw();
        }
    }

    // What the program throws, a trap too, ends the test.
    call(name, ...values) { return this.#exports[name](...values); }

    // Memory of the program that a call takes over: its address and length.
    copyIn(content) {
        const taken = typeof content === 'string' ? encoder.encode(content) : content;
        const at = this.call('allocate', taken.length);
        if (at === 0)
            throw new Error(`no memory for ${taken.length} bytes`);
        new Uint8Array(this.#exports.memory.buffer).set(taken, at);
        return [at, taken.length];
    }

    // Draws what is due, as the page does. Returns after how many seconds the next frame is due; below 0: after an event.
    draw() {
        let wait = 0;
        for (let i = 0; i < MOST_FRAMES && wait >= 0 && wait < AT_ONCE; ++i)
            wait = this.call('step');
        return wait;
    }

    open(address) {
        this.call('openAddress', ...this.copyIn(address));
        this.draw();
    }

    // The answer to a message, which is a text, bytes or a value.
    send(message) {
        const before = this.posted.length;
        const isPlain = typeof message === 'string' || message instanceof Uint8Array;
        this.call('receive', ...this.copyIn(isPlain ? message : JSON.stringify(message)));
        if (this.posted.length !== before + 1)
            throw new Error(`${this.posted.length - before} answers`);
        return JSON.parse(this.posted.at(-1));
    }

    get scene() { return this.send({ texplorer: 1, do: 'read' }).scene; }
    set(path, value) { return this.send({ texplorer: 1, do: 'set', path, value }); }

    press(code, modifiers = 0) {
        this.call('keyChanged', 0, code, modifiers);
        this.call('keyChanged', 2, code, modifiers);
        this.draw();
    }

    give(files) {
        for (const [name, bytes] of Object.entries(files))
            this.call('addFile', ...this.copyIn(name), ...this.copyIn(bytes));
        this.call('filesGiven', 0);
        this.draw();
    }

    // The middle of a widget, or null if it is not seen. The first time, a frame tells where widgets are.
    find(name) {
        this.call('placeOf', ...this.copyIn(name), 0);
        this.draw();
        const edges = [0, 1, 2, 3].map((edge) => this.call('placeOf', ...this.copyIn(name), edge));
        return edges[0] < 0 ? null : [(edges[0] + edges[2]) / 2, (edges[1] + edges[3]) / 2];
    }

    click(name) {
        const middle = this.find(name);
        if (!middle)
            throw new Error(`${name} is not seen`);
        this.call('pointerMoved', ...middle);
        this.draw();
        this.call('buttonChanged', 0, 1, 0);
        this.call('buttonChanged', 0, 0, 0);
        this.draw();
    }

    // The paths and contents of the files below a folder.
    files(path) {
        let folder = this.storage.root.dir;
        for (const name of path.split('/').filter(Boolean))
            folder = folder.contents.get(name);
        return new Map([...folder.contents].flatMap(([name, each]) =>
            (each.contents ? [...this.files(`${path}/${name}`)] : [[`${path}/${name}`, each.data]])));
    }
}
