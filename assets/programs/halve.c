#include "gl.h"

/* The next mip level: each texel is the average of four, or of two where there is one row or column. The
 * texels take the place of those that they are made of. */
static void halve(GLubyte *texels, GLsizei *width, GLsizei *height)
{
    const int right = *width > 1 ? 4 : 0;
    const int up = *height > 1 ? 4 * *width : 0;
    const int w = *width > 1 ? *width / 2 : 1;
    const int h = *height > 1 ? *height / 2 : 1;
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const GLubyte *from = texels + (up > 0 ? 2 * y : y) * 4 * *width + (right > 0 ? 2 * x : x) * 4;
            for (int i = 0; i < 4; ++i) {
                const int sum = from[i] + from[right + i] + from[up + i] + from[up + right + i];
                texels[4 * (y * w + x) + i] = (GLubyte)((sum + 2) / 4);
            }
        }
    }
    *width = w;
    *height = h;
}
