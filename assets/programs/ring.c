#include "grid.c"

/* A row of vertices around the y axis, eastwards from the back: s goes around once. `outwards` and `up` say
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
