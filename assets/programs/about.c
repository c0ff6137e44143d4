#include "translation.c"

/* What turns or scales about the origin does so about a point. */
static Matrix about(double x, double y, double z, Matrix matrix)
{
    return multiply(multiply(translation(x, y, z), matrix), translation(-x, -y, -z));
}
