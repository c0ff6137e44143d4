// What normals are multiplied by: the inverse of the rotation and scale, transposed, by Cramer's rule.
function setNormalMatrix(program, name, m) {
    const normal = [];
    for (let i = 0; i < 3; ++i) {
        const a = 4 * ((i + 1) % 3);
        const b = 4 * ((i + 2) % 3);
        for (let j = 0; j < 3; ++j) {
            const k = (j + 1) % 3;
            const l = (j + 2) % 3;
            normal.push(m[a + k] * m[b + l] - m[a + l] * m[b + k]);
        }
    }
    const determinant = m[0] * normal[0] + m[4] * normal[3] + m[8] * normal[6];
    gl.uniformMatrix3fv(gl.getUniformLocation(program, name), false, normal.map((each) => each / determinant));
}
