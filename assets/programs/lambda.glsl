// Lambda: how many times the image is to be halved for a texel to be as large as a pixel.
float lambda(sampler2D image, vec2 place) {
    vec2 texels = place * vec2(textureSize(image, 0));
    return log2(max(length(dFdx(texels)), length(dFdy(texels))));
}
