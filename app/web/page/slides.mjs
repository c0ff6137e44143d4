// An example of slides around the window, which reveal.js shows (docs/web.md). A slide's data-scene is the file of a scene for
// its window; its last shown data-set has parameters, as "textures[0].wrapS=GL_CLAMP"; .said says what the window has said.

import Reveal from './reveal/reveal.mjs';

const deck = new Reveal({
    width: '100%', height: '100%', margin: 0, minScale: 1, maxScale: 1, // windows are sharp, and as large as they look
    center: false, display: 'grid', hash: true, transition: 'fade', controls: false, scrollActivationWidth: 0,
});
const originOf = (frame) => new URL(frame.src).origin;
const shownFrame = () => deck.getCurrentSlide().querySelector('iframe');
const send = (frame, message) => frame.contentWindow.postMessage({ texplorer: 1, ...message }, originOf(frame));

function setShown() {
    const steps = [...deck.getCurrentSlide().querySelectorAll('[data-set]')];
    const shown = steps.filter((each) => !each.matches('.fragment:not(.visible)')).at(-1);
    steps.forEach((each) => each.classList.toggle('now', each === shown));
    for (const edit of shown?.dataset.set.split(' ') ?? []) {
        const [path, value] = edit.split('=');
        send(shownFrame(), { do: 'set', path, value });
    }
}

async function isReady(frame) {
    const file = deck.getCurrentSlide().dataset.scene;
    send(frame, file ? { id: 'scene', do: 'load', scene: await (await fetch(file)).json() } : { do: 'read' }); // it then tells of lessons
}

window.addEventListener('message', ({ source, origin, data }) => {
    const frame = shownFrame();
    if (!frame || source !== frame.contentWindow || origin !== originOf(frame))
        return;
    const said = deck.getCurrentSlide().querySelector('.said');
    if (data.event === 'ready') {
        isReady(frame);
    } else if (data.id === 'scene' && !data.error) {
        setShown();
    } else if (data.error) {
        said.textContent = data.error;
    } else if (data.event === 'lesson' && (data.done || data.answer)) {
        said.textContent = data.answer ? `Answer ${data.answer} was given.` : 'Done.';
        said.classList.toggle('done', data.done);
    }
});

for (const event of ['fragmentshown', 'fragmenthidden'])
    deck.on(event, setShown);
deck.on('slidechanged', () => document.activeElement.blur()); // a window that is gone had the keys
deck.initialize();
