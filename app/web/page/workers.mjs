// The Web Workers that draw pictures for the program (app/web/page_drawing.h).

export class Workers {
    #module;
    #bytesAt;
    #textAt;
    #drawn;
    #failed;
    #workers = new Map(); // number → Worker
    #made = 0;

    // `module` is the program, compiled. `bytesAt` and `textAt` copy from its memory. `drawn` is called with a worker's number
    // and an answer of Drawer.draw, `failed` with its number and a reason.
    constructor(module, bytesAt, textAt, drawn, failed) {
        this.#module = module;
        this.#bytesAt = bytesAt;
        this.#textAt = textAt;
        this.#drawn = drawn;
        this.#failed = failed;
    }

    // Returns a number above 0; 0: the browser makes none.
    makeWorker() {
        const number = this.#made + 1;
        let worker = null;
        try {
            worker = new Worker(new URL('picture_worker.mjs', import.meta.url), { type: 'module' });
            worker.postMessage({ module: this.#module });
            const heard = (tell) => (event) => { // an event can be on its way when the worker is dropped
                if (this.#workers.get(number) === worker)
                    tell(event);
            };
            worker.onmessage = heard(({ data }) => (data.error === undefined ? this.#drawn(number, data) : this.#failed(number, data.error)));
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

    // What can't be sent, for lack of memory, ends the worker.
    #send(number, messageOf) {
        try {
            this.#workers.get(number).postMessage(messageOf());
        } catch (error) {
            queueMicrotask(() => this.#failed(number, String(error.message ?? error)));
        }
    }
}
