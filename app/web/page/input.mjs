// Reports pointer, touch and keyboard to the program, in the units and codes of app/stage/event.h.

const LONG_PRESS = 500; // milliseconds
const SLOP = 10; // CSS pixels that a resting finger may move
const LINE = 100 / 3; // CSS pixels of one line, where a wheel counts lines
const NOTCH = 100; // CSS pixels of one notch
const NOTCHES = 7; // of the wheel that double the size
const RIGHT = 1;
const EXPLAIN = 69; // E
const PRESS = 0;
const REPEAT = 1;
const RELEASE = 2;

// KeyboardEvent.code → GLFW's code (app/ui/widgets/keys.h) of keys that have no letter.
const KEYS = {
    Space: 32, Quote: 39, Comma: 44, Minus: 45, Period: 46, Slash: 47, Semicolon: 59, Equal: 61, BracketLeft: 91,
    Backslash: 92, BracketRight: 93, Backquote: 96, Escape: 256, Enter: 257, Tab: 258, Backspace: 259, Insert: 260,
    Delete: 261, ArrowRight: 262, ArrowLeft: 263, ArrowDown: 264, ArrowUp: 265, PageUp: 266, PageDown: 267, Home: 268,
    End: 269, NumpadDivide: 331, NumpadMultiply: 332, NumpadSubtract: 333, NumpadAdd: 334, NumpadEnter: 335,
    ShiftLeft: 340, ControlLeft: 341, AltLeft: 342, MetaLeft: 343, ShiftRight: 344, ControlRight: 345, AltRight: 346,
    MetaRight: 347, ContextMenu: 348,
};
for (let i = 1; i <= 12; ++i)
    KEYS[`F${i}`] = 289 + i;
for (let i = 0; i <= 9; ++i)
    KEYS[`Digit${i}`] = 48 + i;

const isMac = /^Mac|^iP/.test(navigator.platform);

// The code of a key: of letters by what they print, else by their place. A keyboard on a screen reports no place.
export function codeOf(event) {
    if (/^[a-z]$/i.test(event.key))
        return event.key.toUpperCase().charCodeAt(0);
    if (/^Key[A-Z]$/.test(event.code))
        return event.code.charCodeAt(3); // another alphabet: shortcuts by the place
    return KEYS[event.code] ?? KEYS[event.key] ?? 0;
}

export function modifiersOf(event) {
    const control = isMac ? event.metaKey : event.ctrlKey;
    const meta = isMac ? event.ctrlKey : event.metaKey;
    return (control ? 1 : 0) | (event.shiftKey ? 2 : 0) | (event.altKey ? 4 : 0) | (meta ? 8 : 0);
}

// The program's functions for events, and `changed`, which is called after each of them.
// `drawNow(count)` draws the next frames at once.
export function listen(canvas, field, program, changed, drawNow) {
    const on = (target, names, handle, options) => {
        for (const name of names.split(' '))
            target.addEventListener(name, (event) => { handle(event); changed(); }, options);
    };
    const moveTo = ({ x, y }) => {
        const box = canvas.getBoundingClientRect();
        program.pointerMoved(x - box.left, y - box.top);
    };
    const move = (event) => moveTo({ x: event.clientX, y: event.clientY });

    const fingers = new Map();
    let touch = null; // what the fingers do: { kind: 'wait' | 'drag' | 'held' | 'two' | 'scroll' | 'pan', timer, x, y, gap }; a list is scrolled by one or two

    const endPress = (event) => program.buttonChanged(0, false, modifiersOf(event));
    let pressed = 0; // the mouse's buttons as a mask: only the first has a pointerdown, the others a pointermove
    const press = (event) => {
        const masks = [1, 2, 4, 8, 16]; // left, right, middle, back, forward, in the order of GLFW's numbers
        masks.forEach((mask, button) => {
            if (((pressed ^ event.buttons) & mask) !== 0)
                program.buttonChanged(button, (event.buttons & mask) !== 0, modifiersOf(event));
        });
        pressed = event.buttons;
    };
    const centre = () => {
        const all = [...fingers.values()];
        const sum = (axis) => all.reduce((total, each) => total + each[axis], 0) / all.length;
        const gap = all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0;
        return { x: sum('x'), y: sum('y'), gap };
    };

    let notch = 0; // CSS pixels of a notch of the wheel, in the list below the fingers; 0: nothing scrolls there
    function scrollsThere() {
        drawNow(1); // the program knows then what is below
        notch = program.scrolledByNotch();
        return notch > 0;
    }

    function fingerDown(event) {
        fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        if (fingers.size === 1) { // the position first: what lies below must know of the finger before the press
            move(event);
            touch = { kind: 'wait', x: event.clientX, y: event.clientY };
            const hold = () => { // the right button, and E, which explains a pixel
                touch.kind = 'held';
                program.buttonChanged(RIGHT, true, 0);
                program.buttonChanged(RIGHT, false, 0);
                program.keyChanged(PRESS, EXPLAIN, 0);
                changed();
            };
            touch.timer = setTimeout(() => { // of a slow page, a move that came earlier is handled first
                touch.timer = setTimeout(hold);
            }, LONG_PRESS);
        } else if (fingers.size === 2 && touch) {
            clearTimeout(touch.timer);
            if (touch.kind === 'drag')
                endPress(event);
            if (touch.kind === 'held')
                program.keyChanged(RELEASE, EXPLAIN, 0);
            touch = { kind: 'two', ...centre() };
            moveTo(touch);
        }
    }

    function fingerMoved(event) {
        if (!fingers.has(event.pointerId) || !touch)
            return;
        fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
        const way = { x: event.clientX - touch.x, y: event.clientY - touch.y };
        if (touch.kind === 'wait' && Math.hypot(way.x, way.y) > SLOP) {
            clearTimeout(touch.timer);
            const scrolls = Math.abs(way.y) > Math.abs(way.x) && scrollsThere();
            touch = { kind: scrolls ? 'scroll' : 'drag', ...centre() };
            if (!scrolls)
                program.buttonChanged(0, true, 0);
        }
        if (touch.kind === 'drag' || touch.kind === 'held')
            move(event);
        if (touch.kind === 'two') { // a list is scrolled, a view is panned and zoomed
            touch.kind = scrollsThere() ? 'scroll' : 'pan';
            if (touch.kind === 'pan')
                program.buttonChanged(RIGHT, true, 0);
        }
        if (touch.kind === 'scroll' || (fingers.size > 1 && touch.kind === 'pan')) {
            const now = centre();
            if (touch.kind === 'pan')
                moveTo(now);
            if (touch.kind === 'pan' && touch.gap > 0 && now.gap > 0)
                program.wheelTurned(0, Math.log2(now.gap / touch.gap) * NOTCHES, 0);
            if (touch.kind === 'scroll')
                program.wheelTurned((now.x - touch.x) / notch, (now.y - touch.y) / notch, 0);
            touch = { kind: touch.kind, ...now };
        }
    }

    function fingerUp(event) {
        fingers.delete(event.pointerId);
        if (!touch)
            return;
        if (fingers.size > 0) { // no jump to the centre of those that are left
            Object.assign(touch, centre());
            return;
        }
        clearTimeout(touch.timer);
        if (touch.kind === 'wait' && event.type === 'pointerup')
            program.buttonChanged(0, true, 0);
        if (touch.kind === 'wait' || touch.kind === 'drag')
            endPress(event);
        if (touch.kind === 'held')
            program.keyChanged(RELEASE, EXPLAIN, 0);
        if (touch.kind === 'scroll' || touch.kind === 'pan')
            drawNow(1); // with the fingers still there, else their last way is lost
        if (touch.kind === 'pan')
            program.buttonChanged(RIGHT, false, 0);
        touch = null;
        program.pointerLeft();
        drawNow(4); // a keyboard on the screen opens only while the tap is handled
    }

    on(canvas, 'pointerdown', (event) => {
        canvas.setPointerCapture(event.pointerId);
        (field.hidden ? canvas : field).focus({ preventScroll: true });
        if (event.pointerType === 'touch')
            return fingerDown(event);
        move(event);
        press(event);
        event.preventDefault();
    });
    on(canvas, 'mousedown', (event) => event.preventDefault()); // it follows a touch, and would take the focus
    on(canvas, 'pointermove', (event) => {
        if (event.pointerType === 'touch')
            return fingerMoved(event);
        move(event);
        press(event);
    });
    on(canvas, 'pointerup pointercancel', (event) => {
        if (event.pointerType === 'touch')
            return fingerUp(event);
        move(event);
        press(event);
    });
    on(canvas, 'pointerleave', (event) => {
        if (event.pointerType !== 'touch' && event.buttons === 0)
            program.pointerLeft();
    });
    on(canvas, 'contextmenu', (event) => event.preventDefault());
    on(canvas, 'wheel', (event) => {
        event.preventDefault();
        move(event);
        const unit = event.deltaMode === 1 ? LINE : event.deltaMode === 2 ? canvas.clientHeight : 1;
        program.wheelTurned(-event.deltaX * unit / NOTCH, -event.deltaY * unit / NOTCH, modifiersOf(event));
    }, { passive: false });

    // The keyboard. What the browser itself needs (reload, its tools, another tab) stays with it.
    const isBrowsers = (event) => event.key === 'F5' || event.key === 'F12' ||
        ((event.ctrlKey || event.metaKey) && /^[rtwnl]$/i.test(event.key) && !event.altKey) ||
        ((event.ctrlKey || event.metaKey) && /^[+\-0=]$/.test(event.key));
    // Shift+Tab leaves the canvas for the page's own controls, which come before it.
    const leaves = (event) => event.key === 'Tab' && event.shiftKey && event.target !== field;
    const pastes = (event) => ((modifiersOf(event) & 1) !== 0 && /^v$/i.test(event.key)) || (event.shiftKey && event.key === 'Insert');
    const held = new Map(); // codes of held keys: the page may lose the keyboard while they are down
    const typed = (text) => {
        for (const character of text)
            program.textEntered(character.codePointAt(0));
    };
    on(window, 'keydown', (event) => {
        if (event.isComposing || event.keyCode === 229 || isBrowsers(event) || !isOurs(event.target) || leaves(event))
            return;
        const code = codeOf(event);
        if (pastes(event)) // the event paste has the text
            return;
        if (code !== 0) {
            program.keyChanged(event.repeat ? REPEAT : PRESS, code, modifiersOf(event));
            held.set(event.code || event.key, code);
        }
        const isText = [...event.key].length === 1 && !event.ctrlKey && !event.metaKey;
        if (event.target !== field) {
            if (isText)
                typed(event.key);
            if (code !== 0 || isText)
                event.preventDefault();
        } else if (!isText && !/^(Unidentified|Dead|Process)$/.test(event.key) && code !== 259 && code !== 257) {
            event.preventDefault();
        }
    });
    on(window, 'keyup', (event) => {
        const name = event.code || event.key;
        const code = held.get(name);
        held.delete(name);
        if (code !== undefined)
            program.keyChanged(RELEASE, code, modifiersOf(event));
        if (event.key === 'Meta') { // macOS reports no release of what was held with it
            for (const each of held.values())
                program.keyChanged(RELEASE, each, modifiersOf(event));
            held.clear();
        }
    });
    const isOurs = (target) => target === canvas || target === field || target === document.body;

    // Text of an input method or of a keyboard on the screen arrives in the field.
    on(field, 'input', (event) => {
        if (event.isComposing)
            return;
        if (event.inputType === 'insertText')
            typed(event.data ?? '');
        field.value = '';
    });
    on(field, 'compositionend', (event) => {
        typed(event.data);
        field.value = '';
    });
    on(field, 'beforeinput', (event) => { // Android reports these as text changes without a key
        const keys = { deleteContentBackward: 259, insertLineBreak: 257, insertParagraph: 257 };
        const code = keys[event.inputType];
        if (!code || [...held.values()].includes(code))
            return;
        program.keyChanged(PRESS, code, 0);
        program.keyChanged(RELEASE, code, 0);
        event.preventDefault();
    });

    on(document, 'paste', (event) => {
        const text = event.clipboardData?.getData('text/plain');
        if (!text || event.clipboardData.files.length > 0) // files.mjs opens those
            return;
        program.clipboardChanged(text);
        program.keyChanged(PRESS, 86, 1);
        program.keyChanged(RELEASE, 86, 1);
        event.preventDefault();
    });
    on(window, 'focus', () => program.focusChanged(true));
    on(window, 'blur', () => {
        for (const code of held.values())
            program.keyChanged(RELEASE, code, 0);
        held.clear();
        program.focusChanged(false);
    });
}
