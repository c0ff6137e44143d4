#include "gl.h"

/* The board of checker.c in the OpenGL Programming Guide: dark squares, and others of a colour. */
static void checkerboard(GLubyte *texels, int size, int square, GLubyte red, GLubyte green, GLubyte blue)
{
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int light = ((x & square) == 0) != ((y & square) == 0);
            GLubyte *texel = texels + 4 * (y * size + x);
            texel[0] = light ? red : 0;
            texel[1] = light ? green : 0;
            texel[2] = light ? blue : 0;
            texel[3] = 255;
        }
    }
}
