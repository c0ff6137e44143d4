#include "grid.c"

/* Radius 1, facing +z, the picture flat on it; from an angle in degrees from +y towards +x. */
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
