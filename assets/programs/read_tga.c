#include "gl.h"

#include <stdio.h>
#include <stdlib.h>

/* Reads a TGA of 24 or 32 bits a pixel that isn't compressed: RGBA, bottom row first. It has to have the size
 * that the texture has. */
static void readTga(const char *path, GLsizei width, GLsizei height, GLubyte *texels)
{
    unsigned char header[18];
    FILE *file = fopen(path, "rb");
    if (!file || fread(header, 1, sizeof header, file) != sizeof header || header[2] != 2) {
        fprintf(stderr, "%s: no TGA file of colours\n", path);
        exit(EXIT_FAILURE);
    }
    const int bytes = header[16] / 8;
    if ((header[12] | header[13] << 8) != width || (header[14] | header[15] << 8) != height || bytes < 3) {
        fprintf(stderr, "%s: no picture of %d x %d pixels of 24 or 32 bits\n", path, width, height);
        exit(EXIT_FAILURE);
    }
    const int topFirst = (header[17] & 0x20) != 0;
    fseek(file, header[0], SEEK_CUR); /* a text */
    for (int row = 0; row < height; ++row) {
        GLubyte *texel = texels + (size_t)(topFirst ? height - 1 - row : row) * width * 4;
        for (int x = 0; x < width; ++x, texel += 4) {
            texel[2] = (GLubyte)fgetc(file); /* blue, green, red */
            texel[1] = (GLubyte)fgetc(file);
            texel[0] = (GLubyte)fgetc(file);
            texel[3] = bytes == 4 ? (GLubyte)fgetc(file) : 255;
        }
    }
    fclose(file);
}
