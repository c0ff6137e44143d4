#include "degree.c"
#include "matrix.c"

#include <math.h>

/* As gluPerspective: the angle is vertical, in degrees. */
static Matrix perspective(double angle, double aspect, double nearest, double farthest)
{
    const double top = nearest * tan(angle * degree / 2);
    const double right = top * aspect;
    const Matrix matrix = {{nearest / right, 0, 0, 0, 0, nearest / top, 0, 0,
                            0, 0, -(farthest + nearest) / (farthest - nearest), -1,
                            0, 0, -2 * farthest * nearest / (farthest - nearest), 0}};
    return matrix;
}
