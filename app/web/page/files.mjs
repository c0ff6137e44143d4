// Files from the user and for the user.

const MOST = 1 << 30; // bytes of one file; the program has 2 GiB in all

// Gives a file to the user.
export function download(name, bytes) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes]));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

async function* entriesOf(item) {
    if (item.isFile) {
        yield await new Promise((resolve, reject) => item.file(resolve, reject));
    } else if (item.isDirectory) {
        const reader = item.createReader();
        for (;;) { // it returns a part at a time
            const entries = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
            if (entries.length === 0)
                return;
            for (const entry of entries)
                yield* entriesOf(entry);
        }
    }
}

// Files of a drop, also those in dropped folders.
async function filesOf(transfer) {
    const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
    if (entries.length === 0)
        return [...transfer.files];
    const files = [];
    for (const entry of entries) {
        for await (const file of entriesOf(entry))
            files.push(file);
    }
    return files;
}

// `give(files, answers)` gets [{ name, bytes }]; `refuse(name)` the name of a file that can't be read.
export class Files {
    #give;
    #refuse;
    #chooser = document.createElement('input');

    constructor(give, refuse) {
        this.#give = give;
        this.#refuse = refuse;
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

    choose() { this.#chooser.click(); }

    async #read(files, answers) {
        const read = [];
        for (const file of files) {
            try {
                if (file.size > MOST)
                    throw new RangeError('too large');
                read.push({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
            } catch {
                this.#refuse(file.name);
            }
        }
        if (read.length > 0)
            this.#give(read, answers);
    }
}
