#include "matrix.c"

/* As glScale. */
static Matrix scaling(double x, double y, double z)
{
    const Matrix matrix = {{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}};
    return matrix;
}
