function setMatrix(program, name, matrix) {
    gl.uniformMatrix4fv(gl.getUniformLocation(program, name), false, matrix);
}
