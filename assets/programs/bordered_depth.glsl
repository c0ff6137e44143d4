// A depth texture with GL_CLAMP_TO_BORDER on the axes that end, which WebGL hasn't: of the texels that r is compared
// with, those beyond the edge have the border's depth, of which the answer is known.
float borderedDepth(sampler2DShadow image, vec3 place, bool averages, bvec2 ends, float beyond) {
    vec2 size = vec2(textureSize(image, 0));
    vec2 texels = place.st * size;
    vec2 within = averages ? clamp(texels + 0.5, 0.0, 1.0) * clamp(size - texels + 0.5, 0.0, 1.0)
                           : vec2(greaterThanEqual(texels, vec2(0.0))) * vec2(lessThan(texels, size));
    within = mix(vec2(1.0), within, vec2(ends));
    return mix(beyond, textureLod(image, place, 0.0), within.s * within.t);
}
