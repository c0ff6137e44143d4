#include "gl.h"

/* The place is the colour: red grows to the right, green upwards. */
static void gradient(GLubyte *texels)
{
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            GLubyte *texel = texels + 4 * (y * 256 + x);
            texel[0] = (GLubyte)x;
            texel[1] = (GLubyte)y;
            texel[2] = (GLubyte)(255 - (x + y) / 2);
            texel[3] = 255;
        }
    }
}
