#include "gl.h"

/* One colour everywhere. */
static void fill(GLubyte *texels, int count, GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha)
{
    for (int i = 0; i < count; ++i) {
        texels[4 * i] = red;
        texels[4 * i + 1] = green;
        texels[4 * i + 2] = blue;
        texels[4 * i + 3] = alpha;
    }
}
