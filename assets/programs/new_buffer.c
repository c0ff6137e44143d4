#include "gl.h"

#include <stdlib.h>

/* A new buffer, bound to the target, with a copy of the bytes. */
static GLuint newBuffer(GLenum target, size_t size, const void *bytes)
{
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, (GLsizeiptr)size, bytes, GL_STATIC_DRAW);
    return buffer;
}

/* Where an input of the vertex shader lies in the buffer that is bound: so many floats, `stride` bytes from
 * vertex to vertex. */
static void attribute(GLuint location, GLint count, size_t stride, size_t offset)
{
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void *)offset);
}
