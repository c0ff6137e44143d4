// A Web Worker that draws pictures: answers each { scene, numbers }, in order. An error ends its work.

import { Drawer } from './drawer.mjs';

let drawer = null;

self.onmessage = ({ data }) => {
    try {
        if (data.module)
            drawer = new Drawer(data.module);
        if (data.file !== undefined)
            drawer.setFile(data.file, data.bytes);
        if (data.scene !== undefined) {
            const drawn = drawer.draw(data.scene, ...data.numbers);
            self.postMessage(drawn, [drawn.pixels.buffer]);
        }
    } catch (error) {
        self.postMessage({ error: String(error.message ?? error) });
    }
};
