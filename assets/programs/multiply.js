// What b does, then what a does. A matrix is 16 numbers, column by column as OpenGL has it.
function multiply(a, b) {
    const product = [];
    for (let column = 0; column < 16; column += 4) {
        for (let row = 0; row < 4; ++row) {
            product.push(a[row] * b[column] + a[4 + row] * b[column + 1] + a[8 + row] * b[column + 2] + a[12 + row] * b[column + 3]);
        }
    }
    return product;
}
