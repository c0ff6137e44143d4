// Opens the window in the page: loads the program and its fonts, passes events to it, and draws when a frame is due.

import * as embedding from './embedding.mjs';
import { download, Files } from './files.mjs';
import { listen } from './input.mjs';
import { Panels } from './panels.mjs';
import { SceneDevice } from './scene.mjs';
import { show } from './spoken.mjs';
import { Storage } from './storage.mjs';
import { ConsoleStdout, WASI } from './wasi/index.js';
import { Workers } from './workers.mjs';

const canvas = document.querySelector('canvas');
const field = document.querySelector('#field');
const message = document.querySelector('#message');
const encoder = new TextEncoder();
const decoder = new TextDecoder();

// ImGuiMouseCursor, in its order.
const CURSORS = ['default', 'text', 'move', 'ns-resize', 'ew-resize', 'nesw-resize', 'nwse-resize', 'pointer', 'not-allowed'];

const isFramed = window.parent !== window;

let exports = null;
let panels = null;
let scene = null;
let workers = null;
let redraw = () => {};
let post = embedding.post;
const bytes = () => new Uint8Array(exports.memory.buffer);

function stop(reason) {
    exports = null;
    message.textContent = reason;
    message.hidden = false;
    canvas.classList.add('stopped');
}

// Calls a function of the program. What it throws ends the program: the page says so.
function call(name, ...values) {
    if (!exports)
        return undefined;
    try {
        return exports[name](...values);
    } catch (error) {
        console.error(error);
        stop(`Texplorer has stopped (${error.message || error}). Unsaved work is kept and offered when you reload the page.`);
        return undefined;
    }
}

// Memory of the program that a call takes over: its address and length.
function copyIn(content) {
    const taken = typeof content === 'string' ? encoder.encode(content) : content;
    const at = call('allocate', taken.length);
    if (!at) {
        if (exports)
            stop('Texplorer has stopped: there is not enough memory. Unsaved work is kept and offered when you reload the page.');
        return [0, 0];
    }
    bytes().set(taken, at);
    return [at, taken.length];
}

const bytesAt = (at, length) => bytes().slice(at, at + length);
const textAt = (at, length) => decoder.decode(bytesAt(at, length));

const methodsOf = (kind) => Object.getOwnPropertyNames(kind.prototype)
    .filter((name) => !['constructor', 'gl', 'restore'].includes(name));

// What the program calls (browser.h).
function browserFor(storage, files) {
    const browser = {
        fetchFont: () => writeFont(storage, 'Chinese.ttf')
            .then(() => call('refresh'), () => call('fileRefused', ...copyIn('fonts/Chinese.ttf'))).then(() => redraw()),
        chooseFiles: () => files.choose(),
        saveFile: (name, nameLength, at, length) => download(textAt(name, nameLength), bytesAt(at, length)),
        writeClipboard: (at, length) => {
            const written = navigator.clipboard?.writeText(textAt(at, length)) ?? Promise.reject(new Error('no clipboard'));
            written.catch(() => { call('clipboardRefused'); redraw(); });
        },
        speak: (at, length) => show(JSON.parse(textAt(at, length)), {
            answer: (number) => { call('answer', number); redraw(); },
            goToStep: (step) => { call('goToStep', step); redraw(); },
        }),
        postMessage: (at, length) => post(textAt(at, length)),
        setTitle: (at, length) => { document.title = textAt(at, length); },
        setCursor: (shape) => { canvas.style.cursor = shape < 0 ? 'none' : CURSORS[shape] ?? 'default'; },
        setFullScreen: (fills) => {
            const change = fills ? document.documentElement.requestFullscreen?.() : document.exitFullscreen?.();
            if (change)
                change.catch(() => call('fullScreenChanged', Boolean(document.fullscreenElement)));
            else
                queueMicrotask(() => call('fullScreenChanged', false)); // the browser has no full screen
        },
        setTyping: (typing) => {
            if (field.hidden !== !typing) {
                field.hidden = !typing;
                if ([canvas, field, document.body].includes(document.activeElement))
                    (typing ? field : canvas).focus({ preventScroll: true });
            }
        },
    };
    for (const name of methodsOf(Panels))
        browser[name] = (...values) => panels[name](...values);
    for (const name of methodsOf(SceneDevice))
        browser[name] = (...values) => scene[name](...values);
    for (const name of methodsOf(Workers))
        browser[name] = (...values) => workers[name](...values);
    browser.pictureDrawn = browser.fileMade = browser.fileProgressed = () => {}; // of workers
    return browser;
}

async function fetched(path) {
    const response = await fetch(path);
    if (!response.ok)
        throw new Error(`${path} can't be loaded (${response.status}).`);
    return response;
}

async function compiled(path) {
    const response = await fetched(path);
    if (response.headers.get('Content-Type') === 'application/wasm')
        return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(await response.arrayBuffer());
}

const surface = () => {
    const density = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    return [width, height, Math.round(width * density), Math.round(height * density), density,
        document.visibilityState === 'visible' ? 1 : 0];
};

const fonts = {
    'DejaVuSans.ttf': '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf',
    'DejaVuSansMono.ttf': '/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf',
    'DejaVuSans-Bold.ttf': '/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf', // of sheets
    'Chinese.ttf': '/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf',
};

async function writeFont(storage, name) {
    const response = await fetched(`fonts/${name}`);
    storage.write(fonts[name], new Uint8Array(await response.arrayBuffer()));
}

async function load(storage, files) {
    const isChinese = navigator.language.startsWith('zh'); // else the program fetches that font when it needs it
    const needed = ['DejaVuSans.ttf', 'DejaVuSansMono.ttf', ...(isChinese ? ['Chinese.ttf'] : [])];
    const [module] = await Promise.all([compiled('texplorer.wasm'), storage.open(),
        ...needed.map((name) => writeFont(storage, name))]);
    const log = ConsoleStdout.lineBuffered((line) => console.warn(line));
    const environment = ['HOME=/home', 'XDG_STATE_HOME=/home/state', 'XDG_CONFIG_HOME=/home/config',
        `LANG=${navigator.language.replace('-', '_')}.UTF-8`];
    const wasi = new WASI([], environment, [log, log, log, storage.root], { debug: false });
    const instance = await WebAssembly.instantiate(module,
        { wasi_snapshot_preview1: wasi.wasiImport, browser: browserFor(storage, files) });
    exports = instance.exports;
    wasi.initialize(instance);
    const given = (content) => { // 0: there is not enough memory
        const at = call('allocate', content.length);
        if (at)
            bytes().set(content, at);
        return [at, content.length];
    };
    workers = new Workers(module, bytes, () => storage.files(), (worker, heard) => {
        if (heard.pixels)
            call('takePicture', worker, ...given(heard.pixels), heard.width, heard.height, heard.milliseconds, ...copyIn(heard.problems));
        else if (heard.file)
            call('takeFile', worker, heard.made, ...given(heard.file), ...copyIn(heard.sentences));
        else
            call('fileProgress', worker, heard.share);
        redraw();
    }, (worker, reason) => {
        call('workerEnded', worker, ...copyIn(reason));
        redraw();
    });
}

async function open() {
    let trouble = null; // why nothing can be kept, until the program can be told
    const storage = new Storage((error) => {
        trouble = String(error?.message ?? error);
        if (exports)
            tell();
    });
    const tell = () => {
        if (trouble !== null)
            call('storageFailed', ...copyIn(trouble));
        trouble = null;
        changed();
    };
    const give = (given, answers) => {
        for (const { name, bytes: content } of given) {
            const at = call('allocate', content.length);
            if (at) {
                bytes().set(content, at);
                call('addFile', ...copyIn(name), at, content.length);
            } else {
                call('fileRefused', ...copyIn(name));
            }
        }
        call('filesGiven', answers);
        changed();
    };
    const refuse = (name) => {
        call('fileRefused', ...copyIn(name));
        changed();
    };
    const files = new Files(give, refuse, (name, before, now) => {
        const room = call('allocate', before.length + now.length); // a file that is too large does not stop the program
        if (!room) {
            refuse(name);
            return false;
        }
        call('release', room);
        const used = call('fileChanged', ...copyIn(name), ...copyIn(before), ...copyIn(now));
        changed();
        return used;
    });

    let timer = 0;
    let due = 0; // the animation frame that draws next; 0: none
    function draw() {
        cancelAnimationFrame(due);
        clearTimeout(timer);
        due = 0;
        const wait = call('step');
        if (wait === undefined)
            return;
        for (const file of storage.takeDownloads())
            download(file.name, file.bytes);
        storage.keep();
        if (wait < 0)
            return;
        if (wait < 0.015)
            changed();
        else
            timer = setTimeout(changed, wait * 1000);
    }
    function changed() {
        if (due !== 0 || !exports)
            return;
        clearTimeout(timer);
        if (document.visibilityState === 'visible')
            due = requestAnimationFrame(draw);
        else
            timer = setTimeout(draw, 100); // a hidden page has no animation frames
    }

    redraw = changed;
    await load(storage, files);
    panels = new Panels(canvas, bytes);
    scene = new SceneDevice(panels.gl, panels.textures, () => exports.memory.buffer);
    const hasFingers = window.matchMedia('(pointer: coarse)').matches;
    call('start', ...surface().slice(0, 5), hasFingers, ...copyIn(location.href.replace(/#.*/, '')));
    call('openAddress', ...copyIn(location.hash.slice(1)));
    if (!exports)
        return;

    const program = new Proxy({}, { get: (_, name) => (...values) => call(name, ...values) });
    listen(canvas, field, { ...events(program), clipboardChanged: (text) => program.clipboardChanged(...copyIn(text)) }, changed,
        (count) => { for (let i = 0; i < count; ++i) draw(); });
    const resized = () => {
        call('surfaceChanged', ...surface());
        changed();
    };
    new ResizeObserver(resized).observe(canvas);
    const watchDensity = () => window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`).addEventListener('change', () => {
        resized();
        watchDensity();
    }, { once: true });
    watchDensity();
    const leave = () => { // a browser may end a page that it does not show
        draw();
        call('store');
        storage.keep();
    };
    document.addEventListener('visibilitychange', () => {
        if (document.visibilityState !== 'visible')
            leave();
        resized();
    });
    window.addEventListener('pagehide', leave);
    document.addEventListener('fullscreenchange', () => {
        call('fullScreenChanged', Boolean(document.fullscreenElement));
        changed();
    });
    window.addEventListener('hashchange', () => {
        call('openAddress', ...copyIn(location.hash.slice(1)));
        changed();
    });
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => {
        panels.restore();
        scene.restore();
        call('contextRestored');
        changed();
    });
    await embedding.listen((message) => {
        call('receive', ...copyIn(message));
        changed();
    });
    globalThis.texplorer = { // for scripts in this page, and for tests
        // The answer to a message (app/stage/messages.h).
        send: (message) => {
            let answer = null;
            post = (json) => { answer = JSON.parse(json); };
            call('receive', ...copyIn(JSON.stringify(message)));
            post = embedding.post;
            changed();
            return answer;
        },
        // The left, top, right and bottom of a widget that is seen, or null.
        place: (name) => {
            const edges = [0, 1, 2, 3].map((edge) => call('placeOf', ...copyIn(name), edge));
            changed();
            return edges[0] < 0 ? null : edges;
        },
    };
    tell();
    if (!exports)
        return;
    message.hidden = true;
    if (!isFramed) // the keys stay with a page around this one
        canvas.focus();
    document.documentElement.dataset.state = 'ready';
    navigator.serviceWorker?.register('worker.js').catch((error) => console.warn(error));
    writeFont(storage, 'DejaVuSans-Bold.ttf').catch((error) => console.warn(error));
}

function events(program) {
    const names = ['pointerMoved', 'pointerLeft', 'buttonChanged', 'wheelTurned', 'keyChanged', 'textEntered', 'focusChanged',
        'scrolledByNotch'];
    return Object.fromEntries(names.map((name) => [name, program[name]]));
}

open().catch((error) => {
    console.error(error);
    stop(`Texplorer can't start: ${error.message || error}`);
});
