// A level with GL_CLAMP_TO_BORDER on the axes that end, which WebGL hasn't: of the texels that are averaged, those
// beyond the edge have the border's colour. Without averages it is the texel at the place alone.
vec4 bordered(sampler2D image, vec2 place, float level, bool averages, bvec2 ends, vec4 border) {
    vec2 size = vec2(textureSize(image, int(level)));
    vec2 texels = place * size;
    vec2 within = averages ? clamp(texels + 0.5, 0.0, 1.0) * clamp(size - texels + 0.5, 0.0, 1.0)
                           : vec2(greaterThanEqual(texels, vec2(0.0))) * vec2(lessThan(texels, size));
    within = mix(vec2(1.0), within, vec2(ends));
    vec2 asked = averages ? place : (floor(texels) + 0.5) / size;
    return mix(border, textureLod(image, asked, level), within.s * within.t);
}
