// One colour everywhere.
function fill(count, red, green, blue, alpha) {
    const texels = new Uint8Array(count * 4);
    for (let i = 0; i < count; ++i) texels.set([red, green, blue, alpha], 4 * i);
    return texels;
}
