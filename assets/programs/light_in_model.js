// Where the light is as the model has it, by the inverse of the modelview matrix; transposed: by the transpose of its
// rotation and scale, as one gets it who multiplies the row.
function lightInModel(m, light, transposed) {
    const determinant =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
    const placed = light[3] !== 0;
    const eye = [0, 1, 2].map((i) => light[i] / (placed ? light[3] : 1) - (placed && !transposed ? m[12 + i] : 0));
    const inverse = (row, column) => {
        const a = 4 * ((row + 1) % 3);
        const b = 4 * ((row + 2) % 3);
        const i = (column + 1) % 3;
        const j = (column + 2) % 3;
        return (m[a + i] * m[b + j] - m[a + j] * m[b + i]) / determinant;
    };
    const found = [0, 1, 2].map((i) =>
        [0, 1, 2].reduce((sum, j) => sum + (transposed ? inverse(j, i) : inverse(i, j)) * eye[j], 0));
    return [...found, placed ? 1 : 0];
}
