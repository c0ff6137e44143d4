#include "scaling.c"

/* As glOrtho with the eye in the middle: what is behind it is in sight, too. */
static Matrix orthographic(double right, double top, double farthest)
{
    return scaling(1 / right, 1 / top, -1 / farthest);
}
