// Blending needs alpha while it draws; the page isn't to shine through what it leaves.
function makeOpaque() {
    const background = gl.getParameter(gl.COLOR_CLEAR_VALUE);
    gl.colorMask(false, false, false, true);
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.colorMask(true, true, true, true);
    gl.clearColor(...background);
}
