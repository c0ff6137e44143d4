// An instance of the program that draws pictures of the reference, without a window.

import { Storage } from './storage.mjs';
import { ConsoleStdout, WASI } from './wasi/index.js';

const encoder = new TextEncoder();
const decoder = new TextDecoder();

export class Drawer {
    #exports;
    #storage = new Storage(() => {}); // it is not opened: nothing is kept
    #drawn = null; // the answer to the current request

    // `module` is texplorer.wasm, compiled.
    constructor(module) {
        const log = ConsoleStdout.lineBuffered((line) => console.warn(line));
        const wasi = new WASI([], [], [log, log, log, this.#storage.root], { debug: false });
        const browser = Object.fromEntries(WebAssembly.Module.imports(module).map(({ name }) => [name, () => 0]));
        browser.pictureDrawn = (at, width, height, milliseconds, problems, length) => {
            this.#drawn = { pixels: this.#bytes(at, width * height * 4), width, height, milliseconds,
                problems: decoder.decode(this.#bytes(problems, length)) };
        };
        const instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi.wasiImport, browser });
        this.#exports = instance.exports;
        wasi.initialize(instance);
        this.#exports.filesChanged();
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
        return this.#drawn;
    }
}
