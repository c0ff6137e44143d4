// Radius 1; s goes around, t from the south pole to the north pole.
function sphere(slices, stacks) {
    const vertices = [];
    const indices = [];
    for (let stack = 0; stack <= stacks; ++stack) {
        const [sine, cosine] = circle((2 * stack) / stacks);
        ring(vertices, slices, stack / stacks, sine, -cosine, sine, -cosine);
    }
    for (let stack = stacks - 1; stack >= 0; --stack) band(vertices, indices, slices, stack);
    return shape(vertices, indices);
}
