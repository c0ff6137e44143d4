#include "gl.h"

#include <stdio.h>
#include <stdlib.h>

/* Compiles one stage; what the driver has against it is printed. */
static GLuint compile(GLenum stage, const char *source)
{
    const GLuint shader = glCreateShader(stage);
    GLint done = GL_FALSE;
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (!done) {
        char log[4096];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "%s\nThe shader doesn't compile:\n%s\n", source, log);
        exit(EXIT_FAILURE);
    }
    return shader;
}

/* Links both stages. */
static GLuint newProgram(const char *vertexShader, const char *fragmentShader)
{
    const GLuint object = glCreateProgram();
    const GLuint stages[] = {compile(GL_VERTEX_SHADER, vertexShader), compile(GL_FRAGMENT_SHADER, fragmentShader)};
    GLint done = GL_FALSE;
    for (int i = 0; i < 2; ++i) {
        glAttachShader(object, stages[i]);
        glDeleteShader(stages[i]); /* when the program doesn't need it any more */
    }
    glLinkProgram(object);
    glGetProgramiv(object, GL_LINK_STATUS, &done);
    if (!done) {
        char log[4096];
        glGetProgramInfoLog(object, sizeof log, NULL, log);
        fprintf(stderr, "The shaders can't be linked:\n%s\n", log);
        exit(EXIT_FAILURE);
    }
    return object;
}
