#include "gl.h"

#include <string.h>

/* RGBA texels that are packed as in the "Quite OK Image Format", qoiformat.org: a byte says how a texel
 * differs from the one before it, or which one of those that were seen it is. */
static void unpack(const GLubyte *packed, size_t size, GLubyte *texels)
{
    GLubyte seen[64][4] = {{0}};
    GLubyte texel[4] = {0, 0, 0, 255};
    size_t at = 0;
    while (at < size) {
        const int code = packed[at++];
        int run = 1;
        if (code == 0xFE || code == 0xFF) { /* red, green and blue; alpha, too */
            const int count = code == 0xFE ? 3 : 4;
            for (int i = 0; i < count; ++i)
                texel[i] = packed[at++];
        } else if (code >> 6 == 0) { /* one that was seen */
            memcpy(texel, seen[code], 4);
        } else if (code >> 6 == 1) { /* a small difference */
            texel[0] = (GLubyte)(texel[0] + (code >> 4 & 3) - 2);
            texel[1] = (GLubyte)(texel[1] + (code >> 2 & 3) - 2);
            texel[2] = (GLubyte)(texel[2] + (code & 3) - 2);
        } else if (code >> 6 == 2) { /* that of green, and how the others differ from it */
            const int green = (code & 63) - 32;
            const int others = packed[at++];
            texel[0] = (GLubyte)(texel[0] + green + (others >> 4) - 8);
            texel[1] = (GLubyte)(texel[1] + green);
            texel[2] = (GLubyte)(texel[2] + green + (others & 15) - 8);
        } else { /* the same one again */
            run = (code & 63) + 1;
        }
        memcpy(seen[(texel[0] * 3 + texel[1] * 5 + texel[2] * 7 + texel[3] * 11) % 64], texel, 4);
        for (; run > 0; --run, texels += 4)
            memcpy(texels, texel, 4);
    }
}
