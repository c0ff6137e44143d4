// Numbers as buffers take them.
function shape(vertices, indices) {
    return {vertices: new Float32Array(vertices), indices: new Uint32Array(indices)};
}
