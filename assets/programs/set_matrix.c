#include "gl.h"
#include "matrix.c"

/* Shaders take floats. */
static void setMatrix(GLuint object, const char *name, Matrix matrix)
{
    GLfloat floats[16];
    for (int i = 0; i < 16; ++i)
        floats[i] = (GLfloat)matrix.at[i];
    glUniformMatrix4fv(glGetUniformLocation(object, name), 1, GL_FALSE, floats);
}
