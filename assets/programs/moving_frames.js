function redraw() {} // the next frame comes anyway

function frame(milliseconds) {
    draw(canvas.width, canvas.height, milliseconds / 1000);
    requestAnimationFrame(frame);
}
