#include "degree.c"
#include "matrix.c"

#include <math.h>

/* As glRotate; right angles are exact. */
static Matrix rotation(double degrees, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    const double turn = length > 0 ? remainder(degrees, 360.0) : 0; /* without an axis nothing turns */
    double sine = sin(turn * degree);
    double cosine = cos(turn * degree);
    if (remainder(turn, 90.0) == 0) {
        sine = round(sine);
        cosine = round(cosine);
    }
    if (length > 0) {
        x /= length;
        y /= length;
        z /= length;
    }
    const double rest = 1 - cosine;
    const Matrix matrix = {{rest * x * x + cosine, rest * x * y + sine * z, rest * x * z - sine * y, 0,
                            rest * y * x - sine * z, rest * y * y + cosine, rest * y * z + sine * x, 0,
                            rest * z * x + sine * y, rest * z * y - sine * x, rest * z * z + cosine, 0,
                            0, 0, 0, 1}};
    return matrix;
}
