// A row of vertices around the y axis, eastwards from the back: s goes around once. `outwards` and `up` say where the
// normals point.
function ring(vertices, slices, t, radius, height, outwards, up) {
    for (let slice = 0; slice <= slices; ++slice) {
        const [sine, cosine] = circle((4 * slice) / slices);
        vertices.push(-radius * sine, height, -radius * cosine); // position
        vertices.push(-outwards * sine, up, -outwards * cosine); // normal
        vertices.push(slice / slices, t, 0, 1); // texture coordinates
    }
}
