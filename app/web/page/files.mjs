// Files from the user and for the user.

const MOST = 1 << 30; // bytes of one file; the program has 2 GiB in all
const MOST_WATCHED = 200; // files
const SETTLED = 200; // milliseconds after the last change of a file

// Gives a file to the user.
export function download(name, bytes) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

async function bytesOf(file) {
    if (file.size > MOST)
        throw new RangeError('too large');
    return new Uint8Array(await file.arrayBuffer());
}

// In browsers with the File System Access API: a file can be read again later.
async function* handlesIn(handle) {
    if (handle.kind === 'file') {
        yield handle;
    } else {
        for await (const each of handle.values())
            yield* handlesIn(each);
    }
}

async function* filesIn(item) {
    if (item.isFile) {
        yield await new Promise((resolve, reject) => item.file(resolve, reject));
    } else if (item.isDirectory) {
        const reader = item.createReader();
        for (;;) { // it returns a part at a time
            const entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
            if (entries.length === 0)
                return;
            for (const entry of entries)
                yield* filesIn(entry);
        }
    }
}

// Files, or their handles, of a drop, also those in dropped folders.
async function filesOf(transfer) {
    const items = [...transfer.items].filter((item) => item.kind === 'file');
    const plain = [...transfer.files]; // all at once: the transfer is empty later
    const entries = items.map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
    const handles = await Promise.all(items.map((item) => item.getAsFileSystemHandle?.())).catch(() => []);
    const files = [];
    const hasHandles = handles.length > 0 && handles.every(Boolean);
    for (const each of hasHandles ? handles : entries) {
        for await (const file of hasHandles ? handlesIn(each) : filesIn(each))
            files.push(file);
    }
    return hasHandles || entries.length > 0 ? files : plain;
}

// `give(files, answers)` gets [{ name, bytes }]; `refuse(name)` the name of a file that can't be read.
// `change(name, before, now)` gets the content of a given file that has changed, and returns whether it is used.
export class Files {
    #give;
    #refuse;
    #change;
    #observers = [];
    #chooser = document.createElement('input');

    constructor(give, refuse, change) {
        this.#give = give;
        this.#refuse = refuse;
        this.#change = change;
        this.#chooser.type = 'file';
        this.#chooser.multiple = true;
        this.#chooser.addEventListener('change', () => {
            this.#read([...this.#chooser.files], true);
            this.#chooser.value = ''; // the same file can be chosen again
        });
        window.addEventListener('dragover', (event) => event.preventDefault());
        window.addEventListener('drop', (event) => {
            event.preventDefault();
            filesOf(event.dataTransfer).then((files) => this.#read(files, false), () => this.#refuse('The dropped folder'));
        });
        document.addEventListener('paste', (event) => {
            const files = [...(event.clipboardData?.files ?? [])];
            if (files.length > 0) {
                event.preventDefault();
                this.#read(files, false);
            }
        });
    }

    async choose() {
        try {
            this.#read(await window.showOpenFilePicker({ multiple: true }), true);
        } catch (error) {
            if (error.name !== 'AbortError') // the browser has no such chooser, or does not open it now
                this.#chooser.click();
        }
    }

    async #read(files, answers) {
        const read = [];
        for (const each of files) {
            try {
                const bytes = await bytesOf(each.getFile ? await each.getFile() : each);
                read.push({ name: each.name, bytes });
                if (each.getFile)
                    this.#watch(each, bytes);
            } catch {
                this.#refuse(each.name);
            }
        }
        if (read.length > 0)
            this.#give(read, answers);
    }

    async #watch(handle, bytes) {
        if (!window.FileSystemObserver || this.#observers.length >= MOST_WATCHED)
            return;
        let known = bytes;
        let timer = 0;
        const look = async () => {
            const now = await handle.getFile().then(bytesOf).catch(() => known); // it was removed, or is too large
            const isSame = now.length === known.length && now.every((each, i) => each === known[i]);
            if (!isSame && this.#change(handle.name, known, now))
                known = now;
        };
        const observer = new FileSystemObserver(() => {
            clearTimeout(timer);
            timer = setTimeout(look, SETTLED);
        });
        this.#observers.push(observer);
        await observer.observe(handle).catch((error) => console.warn(error));
    }
}
