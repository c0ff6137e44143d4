#include "pi.c"
#include "mesh.c"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Memory for a grid of vertices and the quadrilaterals between them. */
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
