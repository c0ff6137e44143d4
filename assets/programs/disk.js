// Radius 1, facing +z, the picture flat on it; from an angle in degrees from +y towards +x.
function disk(innerRadius, slices, rings, start, sweep) {
    const vertices = [];
    const indices = [];
    for (let row = 0; row <= rings; ++row) {
        const radius = 1 + (row / rings) * (innerRadius - 1);
        for (let slice = slices; slice >= 0; --slice) {
            const turned = sweep === 360 ? slice % slices : slice;
            const [sine, cosine] = circle((start + (sweep * turned) / slices) / 90);
            vertices.push(radius * sine, radius * cosine, 0); // position
            vertices.push(0, 0, 1); // normal
            vertices.push((radius / 2) * sine + 0.5, (radius / 2) * cosine + 0.5, 0, 1); // texture coordinates
        }
    }
    const bands = innerRadius > 0 ? rings : rings - 1;
    const inner = (rings - 1) * (slices + 1);
    for (let i = inner; bands < rings && i < inner + slices; ++i) indices.push(i + slices + 1, i, i + 1); // around the middle
    for (let row = 0; row < bands; ++row) band(vertices, indices, slices, row);
    return shape(vertices, indices);
}
