// The next mip level: each texel is the average of four, or of two where there is one row or column.
function halve(image) {
    const right = image.width > 1 ? 4 : 0;
    const up = image.height > 1 ? 4 * image.width : 0;
    const width = Math.max(1, image.width >> 1);
    const height = Math.max(1, image.height >> 1);
    const texels = new Uint8Array(width * height * 4);
    for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) {
            for (let i = 0; i < 4; ++i) {
                const from = (up > 0 ? 2 * y : y) * 4 * image.width + (right > 0 ? 2 * x : x) * 4 + i;
                const sum = image.texels[from] + image.texels[from + right] + image.texels[from + up] + image.texels[from + up + right];
                texels[4 * (y * width + x) + i] = (sum + 2) >> 2;
            }
        }
    }
    return {width, height, texels};
}
