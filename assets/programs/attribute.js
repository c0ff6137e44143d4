// Where an input of the vertex shader lies in the buffer that is bound: so many floats, `stride` floats from vertex to
// vertex.
function attribute(location, count, stride, offset) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, count, gl.FLOAT, false, 4 * stride, 4 * offset);
}
