#include "gl.h"

/* What a shape is made of: triangles, three indices each. */
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
