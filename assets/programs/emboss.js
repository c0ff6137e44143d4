// Moves coordinates towards the light, vertex by vertex, along the directions in which s and t grow (`tangents`, six
// numbers each): after NeHe's lesson 22.
function emboss(vertices, coords, tangents, light, depth) {
    const moved = new Float32Array(coords);
    for (let i = 0; i < coords.length / 4; ++i) {
        const to = [0, 1, 2].map((k) => light[k] - light[3] * vertices[10 * i + k]);
        const length = Math.hypot(...to);
        for (let k = 0; k < 3 && length > 0; ++k) {
            moved[4 * i] += ((tangents[6 * i + k] * to[k]) / length) * depth * coords[4 * i + 3];
            moved[4 * i + 1] += ((tangents[6 * i + 3 + k] * to[k]) / length) * depth * coords[4 * i + 3];
        }
    }
    return moved;
}
