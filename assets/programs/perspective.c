#include "gl.h"
#include "pi.c"

#include <math.h>

/* As gluPerspective: the angle is vertical, in degrees. */
static void perspective(GLdouble angle, GLdouble aspect, GLdouble nearest, GLdouble farthest)
{
    const GLdouble top = nearest * tan(angle * pi / 180 / 2);
    glFrustum(-top * aspect, top * aspect, -top, top, nearest, farthest);
}
