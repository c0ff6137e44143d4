// The quadrilaterals between a row of vertices and the next, westwards: two triangles each, but one at a pole.
function band(vertices, indices, slices, row) {
    const samePlace = (a, b) => [0, 1, 2].every((i) => vertices[10 * a + i] === vertices[10 * b + i]);
    for (let slice = slices - 1; slice >= 0; --slice) {
        const a = row * (slices + 1) + slice;
        const b = a + 1;
        const c = b + slices + 1;
        const d = a + slices + 1;
        const lower = samePlace(a, b);
        const upper = samePlace(c, d);
        if (lower === upper || upper) indices.push(a, b, d);
        if (lower === upper || lower) indices.push(b, c, d);
    }
}
