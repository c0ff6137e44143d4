#include "gl.h"
#include "matrix.c"

/* What normals are multiplied by: the inverse of the rotation and scale, transposed, by Cramer's rule. */
static void setNormalMatrix(GLuint object, const char *name, Matrix modelView)
{
    GLfloat m[3][3], normal[9];
    for (int i = 0; i < 9; ++i)
        m[i / 3][i % 3] = (GLfloat)modelView.at[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            normal[3 * i + j] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                                m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
    }
    const GLfloat determinant = m[0][0] * normal[0] + m[1][0] * normal[3] + m[2][0] * normal[6];
    for (int i = 0; i < 9; ++i)
        normal[i] *= 1 / determinant;
    glUniformMatrix3fv(glGetUniformLocation(object, name), 1, GL_FALSE, normal);
}
