// The place is the colour: red grows to the right, green upwards.
function gradient() {
    const texels = new Uint8Array(256 * 256 * 4);
    for (let y = 0; y < 256; ++y) {
        for (let x = 0; x < 256; ++x) texels.set([x, y, 255 - ((x + y) >> 1), 255], 4 * (y * 256 + x));
    }
    return texels;
}
