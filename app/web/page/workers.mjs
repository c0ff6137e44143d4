// The Web Workers that draw pictures (app/web/page_drawing.h) and make files (app/web/page_writing.h).

export class Workers {
    #module;
    #memory;
    #files;
    #heard;
    #failed;
    #workers = new Map(); // number → Worker
    #made = 0;

    // `module` is the program, compiled. `memory` returns its memory, `files` the paths and contents of its files. `heard` is
    // called with a worker's number and a message of windowless_worker.mjs, `failed` with its number and a reason.
    constructor(module, memory, files, heard, failed) {
        this.#module = module;
        this.#memory = memory;
        this.#files = files;
        this.#heard = heard;
        this.#failed = failed;
    }

    // Returns a number above 0; 0: the browser makes none.
    makeWorker() { return this.#make(() => ({})); }

    makeFileInCopy(order) {
        return this.#make(() => {
            const memory = this.#memory().slice();
            return { order, copy: { memory: memory.buffer, files: this.#files() } };
        });
    }

    #make(messageOf) {
        const number = this.#made + 1;
        let worker = null;
        try {
            const message = messageOf();
            worker = new Worker(new URL('windowless_worker.mjs', import.meta.url), { type: 'module' });
            worker.postMessage({ module: this.#module, ...message }, message.copy ? [message.copy.memory] : []);
            const heard = (tell) => (event) => { // an event can be on its way when the worker is dropped
                if (this.#workers.get(number) === worker)
                    tell(event);
            };
            worker.onmessage = heard(({ data }) => (data.error === undefined ? this.#heard(number, data) : this.#failed(number, data.error)));
            worker.onerror = heard((event) => this.#failed(number, event.message ?? ''));
            this.#workers.set(number, worker);
        } catch (error) {
            console.warn(error);
            worker?.terminate();
            return 0;
        }
        this.#made = number;
        return number;
    }

    dropWorker(number) {
        this.#workers.get(number)?.terminate();
        this.#workers.delete(number);
    }

    // A file of the scenes that follow; a length of -1 removes it.
    sendFile(number, name, nameLength, at, length) {
        this.#send(number, () => ({ file: this.#textAt(name, nameLength), bytes: length < 0 ? null : this.#bytesAt(at, length) }));
    }

    drawInWorker(number, scene, length, ...numbers) {
        this.#send(number, () => ({ scene: this.#textAt(scene, length), numbers }));
    }

    #bytesAt(at, length) { return this.#memory().slice(at, at + length); }
    #textAt(at, length) { return new TextDecoder().decode(this.#bytesAt(at, length)); }

    // What can't be sent, for lack of memory, ends the worker.
    #send(number, messageOf) {
        try {
            this.#workers.get(number).postMessage(messageOf());
        } catch (error) {
            queueMicrotask(() => this.#failed(number, String(error.message ?? error)));
        }
    }
}
