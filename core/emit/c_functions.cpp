#include "core/emit/c_functions.h"

#include "core/emit/code_writer.h"
#include "core/emit/matrix_functions.h"

#include <array>
#include <string_view>

namespace texplorer::emit {
namespace {

constexpr std::string_view checkerboard =
    R"(/* The board of checker.c in the OpenGL Programming Guide: dark squares, and others of a colour. */
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
)";

constexpr std::string_view gradient =
    R"(/* The place is the colour: red grows to the right, green upwards. */
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
)";

constexpr std::string_view fill =
    R"(/* One colour everywhere. */
static void fill(GLubyte *texels, int count, GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha)
{
    for (int i = 0; i < count; ++i) {
        texels[4 * i] = red;
        texels[4 * i + 1] = green;
        texels[4 * i + 2] = blue;
        texels[4 * i + 3] = alpha;
    }
}
)";

constexpr std::string_view unpack =
    R"(/* RGBA texels that are packed as in the "Quite OK Image Format", qoiformat.org: a byte says how a texel
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
)";

constexpr std::string_view halve =
    R"(/* The next mip level: each texel is the average of four, or of two where there is one row or column. The
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
)";

constexpr std::string_view readBmp =
    R"(/* A number of a file whose low bytes come first. */
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
    fseek(file, (long)little(header + 10, 4), SEEK_SET);
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
)";

constexpr std::string_view readTga =
    R"(/* Reads a TGA of 24 or 32 bits a pixel that isn't compressed: RGBA, bottom row first. It has to have the size
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
)";

constexpr std::string_view readDds =
    R"(/* Turns one block upside down, without decompressing it: of 4 x 4 texels the rows of indices change places,
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

/* Uploads all levels of a DDS file of DXT1, DXT3 or DXT5. The file begins at the top: `flips` turns it around. */
static void readDds(const char *path, int flips)
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
        glCompressedTexImage2D(GL_TEXTURE_2D, level, format, width, height, 0, (GLsizei)size, blocks);
        free(blocks);
        width = width > 1 ? width / 2 : 1;
        height = height > 1 ? height / 2 : 1;
    }
    fclose(file);
}
)";

constexpr std::string_view meshTypes =
    R"(/* What a shape is made of: triangles, three indices each. */
typedef struct {
    GLfloat position[3];
    GLfloat normal[3];
    GLfloat texCoord[4];
} Vertex;

typedef struct {
    Vertex *vertices;
    GLuint *indices;
    GLsizei vertexCount;
    GLsizei indexCount;
} Mesh;
)";

constexpr std::string_view turned =
    R"(/* Memory for a grid of vertices and the quadrilaterals between them. */
static Mesh newMesh(int rows, int columns)
{
    Mesh mesh = {malloc((size_t)rows * columns * sizeof(Vertex)), malloc((size_t)rows * columns * 6 * sizeof(GLuint)),
                 rows * columns, 0};
    if (!mesh.vertices || !mesh.indices) {
        fputs("there is no memory for a shape\n", stderr);
        exit(EXIT_FAILURE);
    }
    return mesh;
}

/* Of an angle in quarter turns. Whole ones are exact, so that poles are points and seams have no gap. */
static void circle(double quarters, GLfloat *sine, GLfloat *cosine)
{
    static const GLfloat exact[] = {0, 1, 0, -1, 0, 1};
    const double rest = quarters - 4 * floor(quarters / 4);
    if (rest == floor(rest)) {
        *sine = exact[(int)rest];
        *cosine = exact[(int)rest + 1];
    } else {
        *sine = (GLfloat)sin(rest * pi / 2);
        *cosine = (GLfloat)cos(rest * pi / 2);
    }
}

static void triangle(Mesh *mesh, GLuint a, GLuint b, GLuint c)
{
    GLuint *indices = mesh->indices + mesh->indexCount;
    indices[0] = a;
    indices[1] = b;
    indices[2] = c;
    mesh->indexCount += 3;
}

static int samePlace(const Mesh *mesh, GLuint a, GLuint b)
{
    const GLfloat *p = mesh->vertices[a].position;
    const GLfloat *q = mesh->vertices[b].position;
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/* The quadrilaterals between a row and the next, westwards: two triangles each, but one at a pole. */
static void band(Mesh *mesh, int slices, int row)
{
    for (int slice = slices - 1; slice >= 0; --slice) {
        const GLuint a = (GLuint)(row * (slices + 1) + slice);
        const GLuint b = a + 1;
        const GLuint c = b + (GLuint)(slices + 1);
        const GLuint d = a + (GLuint)(slices + 1);
        const int lower = samePlace(mesh, a, b);
        const int upper = samePlace(mesh, c, d);
        if (lower == upper || upper)
            triangle(mesh, a, b, d);
        if (lower == upper || lower)
            triangle(mesh, b, c, d);
    }
}
)";

constexpr std::string_view ring =
    R"(/* A row of vertices around the y axis, eastwards from the back: s goes around once. `outwards` and `up` say
 * where the normals point. */
static void ring(Mesh *mesh, int row, int slices, GLfloat t, GLfloat radius, GLfloat height, GLfloat outwards,
                 GLfloat up)
{
    for (int slice = 0; slice <= slices; ++slice) {
        GLfloat sine, cosine;
        circle(4.0 * slice / slices, &sine, &cosine);
        const Vertex vertex = {{-radius * sine, height, -radius * cosine},
                               {-outwards * sine, up, -outwards * cosine},
                               {(GLfloat)slice / (GLfloat)slices, t, 0, 1}};
        mesh->vertices[row * (slices + 1) + slice] = vertex;
    }
}
)";

constexpr std::string_view sphere =
    R"(/* Radius 1; s goes around, t from the south pole to the north pole. */
static Mesh sphere(int slices, int stacks)
{
    Mesh mesh = newMesh(stacks + 1, slices + 1);
    for (int stack = 0; stack <= stacks; ++stack) {
        GLfloat sine, cosine;
        circle(2.0 * stack / stacks, &sine, &cosine);
        ring(&mesh, stack, slices, (GLfloat)stack / (GLfloat)stacks, sine, -cosine, sine, -cosine);
    }
    for (int stack = stacks - 1; stack >= 0; --stack)
        band(&mesh, slices, stack);
    return mesh;
}
)";

constexpr std::string_view cylinder =
    R"(/* From y = -1, with the radius 1, to y = 1; s goes around, t upwards. */
static Mesh cylinder(GLfloat topRadius, int slices, int stacks)
{
    Mesh mesh = newMesh(stacks + 1, slices + 1);
    const GLfloat slope = 1 - topRadius;
    const GLfloat length = 1 / sqrtf(2.0f * 2.0f + slope * slope);
    for (int stack = 0; stack <= stacks; ++stack) {
        const GLfloat share = (GLfloat)stack / (GLfloat)stacks;
        ring(&mesh, stack, slices, share, 1 + share * (topRadius - 1), 2 * share - 1, 2 * length, slope * length);
    }
    for (int stack = 0; stack < stacks; ++stack)
        band(&mesh, slices, stack);
    return mesh;
}
)";

constexpr std::string_view torus =
    R"(/* A ring of radius 1 around the y axis; s goes around it, t around its tube. */
static Mesh torus(GLfloat tubeRadius, int slices, int stacks)
{
    Mesh mesh = newMesh(stacks + 1, slices + 1);
    for (int stack = 0; stack <= stacks; ++stack) {
        GLfloat sine, cosine;
        circle(4.0 * stack / stacks, &sine, &cosine);
        ring(&mesh, stack, slices, (GLfloat)stack / (GLfloat)stacks, 1 - tubeRadius * cosine, -tubeRadius * sine,
             -cosine, -sine);
    }
    for (int stack = 0; stack < stacks; ++stack)
        band(&mesh, slices, stack);
    return mesh;
}
)";

constexpr std::string_view disk =
    R"(/* Radius 1, facing +z, the picture flat on it; from an angle in degrees from +y towards +x. */
static Mesh disk(GLfloat innerRadius, int slices, int rings, double start, double sweep)
{
    Mesh mesh = newMesh(rings + 1, slices + 1);
    GLuint place = 0;
    for (int row = 0; row <= rings; ++row) {
        const GLfloat radius = 1 + (GLfloat)row / (GLfloat)rings * (innerRadius - 1);
        for (int slice = slices; slice >= 0; --slice) {
            GLfloat sine, cosine;
            circle((start + sweep * (sweep == 360 ? slice % slices : slice) / slices) / 90, &sine, &cosine);
            const Vertex vertex = {{radius * sine, radius * cosine, 0},
                                   {0, 0, 1},
                                   {radius / 2 * sine + 0.5f, radius / 2 * cosine + 0.5f, 0, 1}};
            mesh.vertices[place++] = vertex;
        }
    }
    const int bands = innerRadius > 0 ? rings : rings - 1;
    const GLuint inner = (GLuint)((rings - 1) * (slices + 1));
    for (GLuint i = inner; bands < rings && i < inner + (GLuint)slices; ++i)
        triangle(&mesh, i + (GLuint)slices + 1, i, i + 1); /* around the middle */
    for (int row = 0; row < bands; ++row)
        band(&mesh, slices, row);
    return mesh;
}
)";

constexpr std::string_view perspective =
    R"(/* As gluPerspective: the angle is vertical, in degrees. */
static void perspective(GLdouble angle, GLdouble aspect, GLdouble nearest, GLdouble farthest)
{
    const GLdouble top = nearest * tan(angle * pi / 180 / 2);
    glFrustum(-top * aspect, top * aspect, -top, top, nearest, farthest);
}
)";

constexpr std::string_view lightInModel =
    R"(/* Where the light is as the model has it, by the inverse of the modelview matrix; transposed: by the transpose
 * of its rotation and scale, as one gets it who multiplies the row. */
static void lightInModel(const double modelView[16], const GLfloat light[4], int transposed, GLfloat found[4])
{
    double m[16], inverse[9], eye[3];
    for (int i = 0; i < 16; ++i)
        m[i] = (GLfloat)modelView[i];
    const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
                               m[8] * (m[1] * m[6] - m[2] * m[5]);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double *a = m + 4 * ((row + 1) % 3);
            const double *b = m + 4 * ((row + 2) % 3);
            const int i = (column + 1) % 3;
            const int j = (column + 2) % 3;
            inverse[3 * row + column] = (a[i] * b[j] - a[j] * b[i]) / determinant;
        }
    }
    for (int i = 0; i < 3; ++i)
        eye[i] = (double)light[i] / (light[3] != 0 ? light[3] : 1) - (light[3] != 0 && !transposed ? m[12 + i] : 0);
    for (int i = 0; i < 3; ++i) {
        double sum = 0;
        for (int j = 0; j < 3; ++j)
            sum += (transposed ? inverse[3 * j + i] : inverse[3 * i + j]) * eye[j];
        found[i] = (GLfloat)sum;
    }
    found[3] = light[3] != 0 ? 1 : 0;
}
)";

constexpr std::string_view emboss =
    R"(/* Moves coordinates towards the light, vertex by vertex, along the directions in which s and t grow (`tangents`,
 * six numbers each): after NeHe's lesson 22. */
static void emboss(int count, const GLfloat *positions, const GLfloat *coords, const GLfloat *tangents,
                   const GLfloat light[4], GLfloat depth, GLfloat *moved)
{
    for (int i = 0; i < count; ++i) {
        const GLfloat *position = positions + 3 * i;
        const GLfloat *coord = coords + 4 * i;
        GLfloat to[3], offset[2] = {0, 0};
        for (int k = 0; k < 3; ++k)
            to[k] = light[k] - light[3] * position[k];
        const GLfloat length = sqrtf(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
        for (int k = 0; k < 3 && length > 0; ++k) {
            offset[0] += tangents[6 * i + k] * (to[k] / length);
            offset[1] += tangents[6 * i + 3 + k] * (to[k] / length);
        }
        moved[4 * i] = coord[0] + offset[0] * depth * coord[3];
        moved[4 * i + 1] = coord[1] + offset[1] * depth * coord[3];
        moved[4 * i + 2] = coord[2];
        moved[4 * i + 3] = coord[3];
    }
}
)";

struct Row {
    CFunction function;
    std::string_view text;
    std::vector<CFunction> callees{};
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {CFunction::Checkerboard, checkerboard},
        {CFunction::Gradient, gradient},
        {CFunction::Fill, fill},
        {CFunction::Unpack, unpack},
        {CFunction::Halve, halve},
        {CFunction::ReadBmp, readBmp},
        {CFunction::ReadTga, readTga},
        {CFunction::ReadDds, readDds},
        {CFunction::MeshTypes, meshTypes},
        {CFunction::Turned, turned, {CFunction::MeshTypes}},
        {CFunction::Ring, ring, {CFunction::Turned}},
        {CFunction::Sphere, sphere, {CFunction::Ring}},
        {CFunction::Cylinder, cylinder, {CFunction::Ring}},
        {CFunction::Torus, torus, {CFunction::Ring}},
        {CFunction::Disk, disk, {CFunction::Turned}},
        {CFunction::Perspective, perspective},
        {CFunction::LightInModel, lightInModel},
        {CFunction::Emboss, emboss, {CFunction::LightInModel}},
        {CFunction::Matrices, matrixText},
        {CFunction::Degree, degreeText},
        {CFunction::Identity, identityText, {CFunction::Matrices}},
        {CFunction::Translation, translationText, {CFunction::Matrices}},
        {CFunction::Rotation, rotationText, {CFunction::Matrices, CFunction::Degree}},
        {CFunction::Scaling, scalingText, {CFunction::Matrices}},
        {CFunction::About, aboutText, {CFunction::Translation}},
        {CFunction::Frustum, frustumText, {CFunction::Matrices, CFunction::Degree}},
        {CFunction::Orthographic, orthographicText, {CFunction::Scaling}},
        {CFunction::FloatProduct, floatProductText, {CFunction::Matrices}},
        {CFunction::SetMatrix, setMatrixText, {CFunction::Matrices}},
        {CFunction::SetNormalMatrix, setNormalMatrixText, {CFunction::Matrices}},
        {CFunction::NewProgram, compileText},
        {CFunction::Buffers, bufferText},
    };
    return all;
}

} // namespace

void addWithCallees(std::set<CFunction>& functions, CFunction function) {
    functions.insert(function);
    for (const CFunction callee : rows().at(static_cast<std::size_t>(function)).callees)
        addWithCallees(functions, callee);
}

std::vector<Line> linesOf(const std::set<CFunction>& functions) {
    std::vector<Line> lines;
    for (const CFunction function : functions) {
        for (Line& line : linesOf(rows().at(static_cast<std::size_t>(function)).text))
            lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace texplorer::emit
