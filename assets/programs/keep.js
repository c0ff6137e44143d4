// What a texture keeps of an image: for each component one of r, g, b and a, or 0 or 1. WebGL has neither the formats of
// luminance and alpha nor the swizzles that took their place.
function keep(texels, components) {
    const kept = new Uint8Array(texels.length);
    for (let i = 0; i < texels.length; ++i) {
        const component = components[i % 4];
        const from = "rgba".indexOf(component);
        kept[i] = from >= 0 ? texels[i - (i % 4) + from] : 255 * Number(component);
    }
    return kept;
}
