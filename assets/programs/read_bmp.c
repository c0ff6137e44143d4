#include "gl.h"

#include <stdio.h>
#include <stdlib.h>

/* A number of a file whose low bytes come first. */
static unsigned little(const unsigned char *bytes, int count)
{
    unsigned value = 0;
    while (count-- > 0)
        value = value << 8 | bytes[count];
    return value;
}

/* Reads a BMP of 24 or 32 bits a pixel that isn't compressed: RGBA, bottom row first. It has to have the size
 * that the texture has. */
static void readBmp(const char *path, GLsizei width, GLsizei height, GLubyte *texels)
{
    unsigned char header[54];
    FILE *file = fopen(path, "rb");
    if (!file || fread(header, 1, sizeof header, file) != sizeof header || header[0] != 'B' || header[1] != 'M') {
        fprintf(stderr, "%s: no BMP file\n", path);
        exit(EXIT_FAILURE);
    }
    const int rows = (int)little(header + 22, 4); /* negative: the top row comes first */
    const int bytes = (int)little(header + 28, 2) / 8;
    if ((GLsizei)little(header + 18, 4) != width || (rows != height && rows != -height) || bytes < 3) {
        fprintf(stderr, "%s: no picture of %d x %d pixels of 24 or 32 bits\n", path, width, height);
        exit(EXIT_FAILURE);
    }
    const int padding = (4 - width * bytes % 4) % 4; /* a row has a multiple of 4 bytes */
    const long start = (long)little(header + 10, 4); /* 0: who wrote it left that out */
    fseek(file, start > 0 ? start : 14 + (long)little(header + 14, 4), SEEK_SET);
    for (int row = 0; row < height; ++row) {
        GLubyte *texel = texels + (size_t)(rows > 0 ? row : height - 1 - row) * width * 4;
        for (int x = 0; x < width; ++x, texel += 4) {
            texel[2] = (GLubyte)fgetc(file); /* blue, green, red */
            texel[1] = (GLubyte)fgetc(file);
            texel[0] = (GLubyte)fgetc(file);
            texel[3] = bytes == 4 ? (GLubyte)fgetc(file) : 255;
        }
        fseek(file, padding, SEEK_CUR);
    }
    fclose(file);
}
