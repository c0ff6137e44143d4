// Dragging turns the view, the wheel goes nearer; keys do the same.
canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
canvas.addEventListener("pointermove", (event) => {
    if (event.buttons & 1) turn(-event.movementX / 2, event.movementY / 2, 1);
});
canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    turn(0, 0, 0.9 ** (-event.deltaY / 100));
}, {passive: false});
canvas.addEventListener("keydown", (event) => {
    const steps = {
        ArrowLeft: [5, 0, 1], ArrowRight: [-5, 0, 1], ArrowUp: [0, -5, 1], ArrowDown: [0, 5, 1],
        "+": [0, 0, 0.9], "-": [0, 0, 1 / 0.9],
    };
    if (steps[event.key]) turn(...steps[event.key]);
});

function turn(aside, upwards, farther) {
    azimuth += aside;
    elevation += upwards;
    distance *= farther;
    redraw();
}

// As many pixels as the screen has where the canvas is.
function resize() {
    const width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio));
    const height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
    if (canvas.width === width && canvas.height === height) return;
    canvas.width = width;
    canvas.height = height;
    redraw();
}
