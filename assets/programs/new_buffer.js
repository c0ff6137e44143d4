// A new buffer, bound to the target, with a copy of the numbers.
function newBuffer(target, numbers) {
    const buffer = gl.createBuffer();
    gl.bindBuffer(target, buffer);
    gl.bufferData(target, numbers, gl.STATIC_DRAW);
    return buffer;
}
