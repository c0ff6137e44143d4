/* A matrix, column by column as OpenGL has it. It is made in doubles, so that what turns for hours turns smoothly,
 * and rounded for the shader. */
typedef struct {
    double at[16];
} Matrix;

/* What b does, then what a does. */
static Matrix multiply(Matrix a, Matrix b)
{
    Matrix product;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            double sum = 0;
            for (int i = 0; i < 4; ++i)
                sum += a.at[4 * i + row] * b.at[4 * column + i];
            product.at[4 * column + row] = sum;
        }
    }
    return product;
}
