// RGBA texels that are packed as in the "Quite OK Image Format", qoiformat.org: a byte says how a texel differs
// from the one before it, or which one of those that were seen it is.
function unpack(packed, count) {
    const texels = new Uint8Array(count * 4);
    const seen = new Uint8Array(64 * 4);
    const texel = new Uint8Array([0, 0, 0, 255]);
    for (let at = 0, to = 0; at < packed.length; ) {
        const code = packed[at++];
        let run = 1;
        if (code >= 0xfe) { // red, green and blue; alpha, too
            for (let i = 0; i < code - 0xfb; ++i) texel[i] = packed[at++];
        } else if (code >> 6 === 0) { // one that was seen
            texel.set(seen.subarray(4 * code, 4 * code + 4));
        } else if (code >> 6 === 1) { // a small difference
            texel[0] += ((code >> 4) & 3) - 2;
            texel[1] += ((code >> 2) & 3) - 2;
            texel[2] += (code & 3) - 2;
        } else if (code >> 6 === 2) { // that of green, and how the others differ from it
            const green = (code & 63) - 32;
            const others = packed[at++];
            texel[0] += green + (others >> 4) - 8;
            texel[1] += green;
            texel[2] += green + (others & 15) - 8;
        } else { // the same one again
            run = (code & 63) + 1;
        }
        seen.set(texel, 4 * ((texel[0] * 3 + texel[1] * 5 + texel[2] * 7 + texel[3] * 11) % 64));
        for (; run > 0; --run, to += 4) texels.set(texel, to);
    }
    return texels;
}
