// An instance of the program without a window: draws pictures of the reference, or makes a file.

import { Storage } from './storage.mjs';
import { ConsoleStdout, WASI } from './wasi/index.js';

const encoder = new TextEncoder();
const decoder = new TextDecoder();
const PAGE = 65536; // bytes

export class Windowless {
    #exports;
    #storage = new Storage(() => {}); // it is not opened: nothing is kept
    #answer = null; // to the current request

    // `module` is texplorer.wasm, compiled. As a copy of another instance, it gets all its memory and its files. `progressed`
    // is called with numbers from 0 to 1.
    constructor(module, { memory, files = [] } = {}, progressed = () => {}) {
        for (const [path, bytes] of files)
            this.#storage.write(path, bytes);
        const log = ConsoleStdout.lineBuffered((line) => console.warn(line));
        const wasi = new WASI([], [], [log, log, log, this.#storage.root], { debug: false });
        const browser = Object.fromEntries(WebAssembly.Module.imports(module).map(({ name }) => [name, () => 0]));
        browser.pictureDrawn = (at, width, height, milliseconds, problems, length) => {
            this.#answer = { pixels: this.#bytes(at, width * height * 4), width, height, milliseconds,
                problems: decoder.decode(this.#bytes(problems, length)) };
        };
        browser.fileProgressed = progressed;
        browser.fileMade = (made, at, count, sentences, length) => {
            this.#answer = { made: Boolean(made), file: this.#bytes(at, count), sentences: decoder.decode(this.#bytes(sentences, length)) };
        };
        const instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi.wasiImport, browser });
        this.#exports = instance.exports;
        if (memory) {
            this.#exports.memory.grow((memory.byteLength - this.#exports.memory.buffer.byteLength) / PAGE);
            new Uint8Array(this.#exports.memory.buffer).set(new Uint8Array(memory));
            wasi.initialize({ exports: { memory: this.#exports.memory } }); // the program has started
        } else {
            wasi.initialize(instance);
            this.#exports.filesChanged();
        }
    }

    #bytes(at, length) { return new Uint8Array(this.#exports.memory.buffer, at, length).slice(); }

    // A file of the scenes that follow; null removes it.
    setFile(name, bytes) {
        if (bytes === null)
            this.#storage.root.dir.contents.get('given').contents.delete(name);
        else
            this.#storage.write(`/given/${name}`, bytes);
        this.#exports.filesChanged();
    }

    // The numbers are those of drawPicture (worker_exports.cpp). Returns { pixels, width, height, milliseconds, problems }.
    draw(scene, ...numbers) {
        const text = encoder.encode(scene);
        const at = this.#exports.allocate(text.length);
        if (at === 0)
            throw new Error('there is not enough memory');
        new Uint8Array(this.#exports.memory.buffer).set(text, at);
        this.#exports.drawPicture(at, text.length, ...numbers);
        return this.#answer;
    }

    // `order` is an address in the program of which this one is a copy. Returns { made, file, sentences }.
    makeFile(order) {
        this.#exports.makeFile(order);
        return this.#answer;
    }
}
