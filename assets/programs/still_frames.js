// Nothing moves by itself: a frame is drawn where something has changed.
let isAsked = false;
function redraw() {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(frame);
}

function frame() {
    isAsked = false;
    draw(canvas.width, canvas.height);
}
