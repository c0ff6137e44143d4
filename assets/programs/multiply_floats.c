#include "gl.h"
#include "matrix.c"

/* The product as a shader would make it, in floats. */
static Matrix multiplyFloats(Matrix a, Matrix b)
{
    Matrix product;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            GLfloat sum = 0;
            for (int i = 0; i < 4; ++i)
                sum += (GLfloat)a.at[4 * i + row] * (GLfloat)b.at[4 * column + i];
            product.at[4 * column + row] = sum;
        }
    }
    return product;
}
