// The board of checker.c in the OpenGL Programming Guide: dark squares, and others of a colour.
function checkerboard(size, square, red, green, blue) {
    const texels = new Uint8Array(size * size * 4);
    for (let y = 0; y < size; ++y) {
        for (let x = 0; x < size; ++x) {
            const light = ((x & square) === 0) !== ((y & square) === 0);
            texels.set(light ? [red, green, blue, 255] : [0, 0, 0, 255], 4 * (y * size + x));
        }
    }
    return texels;
}
