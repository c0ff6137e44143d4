#include "gl.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Turns one block upside down, without decompressing it: of 4 x 4 texels the rows of indices change places,
 * or of the two that a picture of 2 rows has. 8 bytes of alpha come first in DXT3 (4 bits a texel) and DXT5 (3
 * bits, after two alphas). */
static void flipBlock(GLubyte *block, GLenum format, int rows)
{
    GLubyte *colors = block;
    if (format == GL_COMPRESSED_RGBA_S3TC_DXT3_EXT || format == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT)
        colors += 8;
    for (int row = 0; row < rows / 2; ++row) {
        const int other = rows - 1 - row;
        GLubyte index = colors[4 + row];
        colors[4 + row] = colors[4 + other];
        colors[4 + other] = index;
        if (format == GL_COMPRESSED_RGBA_S3TC_DXT3_EXT) {
            for (int i = 0; i < 2; ++i) {
                const GLubyte alpha = block[2 * row + i];
                block[2 * row + i] = block[2 * other + i];
                block[2 * other + i] = alpha;
            }
        }
    }
    if (format == GL_COMPRESSED_RGBA_S3TC_DXT5_EXT) { /* 12 bits a row, across bytes */
        unsigned long long bits = 0, turned = 0;
        for (int i = 0; i < 6; ++i)
            bits |= (unsigned long long)block[2 + i] << (8 * i);
        for (int row = 0; row < 4; ++row)
            turned |= (bits >> (12 * (row < rows ? rows - 1 - row : row)) & 0xFFF) << (12 * row);
        for (int i = 0; i < 6; ++i)
            block[2 + i] = (GLubyte)(turned >> (8 * i));
    }
}

/* Uploads the levels of a DDS file of DXT1, DXT3 or DXT5 from `first` on. The file begins at the top: `flips` turns
 * it around. */
static void readDds(const char *path, int flips, int first)
{
    unsigned char header[128];
    FILE *file = fopen(path, "rb");
    if (!file || fread(header, 1, sizeof header, file) != sizeof header || memcmp(header, "DDS ", 4) != 0) {
        fprintf(stderr, "%s: no DDS file\n", path);
        exit(EXIT_FAILURE);
    }
    const GLenum format = header[87] == '1'   ? GL_COMPRESSED_RGBA_S3TC_DXT1_EXT
                          : header[87] == '3' ? GL_COMPRESSED_RGBA_S3TC_DXT3_EXT
                                              : GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
    const size_t blockSize = format == GL_COMPRESSED_RGBA_S3TC_DXT1_EXT ? 8 : 16;
    GLsizei height = header[12] | header[13] << 8;
    GLsizei width = header[16] | header[17] << 8;
    const int levels = header[28] > 0 ? header[28] : 1;
    for (GLint level = 0; level < levels; ++level) {
        const size_t columns = (size_t)(width + 3) / 4;
        const size_t rows = (size_t)(height + 3) / 4;
        const size_t size = columns * rows * blockSize;
        GLubyte *blocks = malloc(size);
        if (!blocks || fread(blocks, 1, size, file) != size) {
            fprintf(stderr, "%s: expected %lu bytes of level %d\n", path, (unsigned long)size, level);
            exit(EXIT_FAILURE);
        }
        for (size_t i = 0; flips && i < rows * columns; ++i) {
            GLubyte *block = blocks + i * blockSize;
            GLubyte *other = blocks + ((rows - 1 - i / columns) * columns + i % columns) * blockSize;
            flipBlock(block, format, height < 4 ? height : 4);
            GLubyte kept[16];
            if (i / columns >= (rows + 1) / 2) { /* the rows of blocks change places, too; both are turned by now */
                memcpy(kept, block, blockSize);
                memcpy(block, other, blockSize);
                memcpy(other, kept, blockSize);
            }
        }
        if (level >= first)
            glCompressedTexImage2D(GL_TEXTURE_2D, level - first, format, width, height, 0, (GLsizei)size, blocks);
        free(blocks);
        width = width > 1 ? width / 2 : 1;
        height = height > 1 ? height / 2 : 1;
    }
    fclose(file);
}
