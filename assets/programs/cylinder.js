// From y = -1, with the radius 1, to y = 1; s goes around, t upwards.
function cylinder(topRadius, slices, stacks) {
    const vertices = [];
    const indices = [];
    const slope = 1 - topRadius;
    const length = Math.hypot(2, slope);
    for (let stack = 0; stack <= stacks; ++stack) {
        const share = stack / stacks;
        ring(vertices, slices, share, 1 + share * (topRadius - 1), 2 * share - 1, 2 / length, slope / length);
    }
    for (let stack = 0; stack < stacks; ++stack) band(vertices, indices, slices, stack);
    return shape(vertices, indices);
}
