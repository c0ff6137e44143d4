// A ring of radius 1 around the y axis; s goes around it, t around its tube.
function torus(tubeRadius, slices, stacks) {
    const vertices = [];
    const indices = [];
    for (let stack = 0; stack <= stacks; ++stack) {
        const [sine, cosine] = circle((4 * stack) / stacks);
        ring(vertices, slices, stack / stacks, 1 - tubeRadius * cosine, -tubeRadius * sine, -cosine, -sine);
    }
    for (let stack = 0; stack < stacks; ++stack) band(vertices, indices, slices, stack);
    return shape(vertices, indices);
}
