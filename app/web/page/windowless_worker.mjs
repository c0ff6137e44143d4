// A Web Worker with an instance of the program: answers each { scene, numbers } and { order }, one after the other. An error
// ends its work.

import { Windowless } from './windowless.mjs';

let program = null;

self.onmessage = ({ data }) => {
    try {
        if (data.module)
            program = new Windowless(data.module, data.copy, (share) => self.postMessage({ share }));
        if (data.file !== undefined)
            program.setFile(data.file, data.bytes);
        if (data.scene !== undefined) {
            const drawn = program.draw(data.scene, ...data.numbers);
            self.postMessage(drawn, [drawn.pixels.buffer]);
        }
        if (data.order !== undefined) {
            const answer = program.makeFile(data.order);
            self.postMessage(answer, [answer.file.buffer]);
        }
    } catch (error) {
        self.postMessage({ error: String(error.message ?? error) });
    }
};
