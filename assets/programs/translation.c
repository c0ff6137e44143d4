#include "matrix.c"

/* As glTranslate. */
static Matrix translation(double x, double y, double z)
{
    const Matrix matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}};
    return matrix;
}
