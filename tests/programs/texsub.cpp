// A part of a texture is replaced, as in the OpenGL Programming Guide, "Replacing All or Part of a Texture
// Image".

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <vector>

namespace texplorer::programs {
namespace {

/// Squares of so many texels, in black and a colour.
std::vector<GLubyte> board(int size, int square, GLubyte red, GLubyte others) {
    std::vector<GLubyte> texels;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const bool isLight = (row / square + column / square) % 2 != 0;
            texels.push_back(isLight ? red : GLubyte{0});
            texels.push_back(isLight ? others : GLubyte{0});
            texels.push_back(isLight ? others : GLubyte{0});
            texels.push_back(255);
        }
    }
    return texels;
}

} // namespace

void drawTexsub(int width, int height) {
    glClearColor(0, 0, 0, 0);
    glEnable(GL_DEPTH_TEST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 board(64, 8, 255, 255).data());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 12, 44, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, board(16, 4, 255, 0).data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60.0, static_cast<double>(width) / height, 1.0, 30.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3.6F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(-2, -1, 0);
    glTexCoord2f(0, 1);
    glVertex3f(-2, 1, 0);
    glTexCoord2f(1, 1);
    glVertex3f(0, 1, 0);
    glTexCoord2f(1, 0);
    glVertex3f(0, -1, 0);
    glTexCoord2f(0, 0);
    glVertex3f(1, -1, 0);
    glTexCoord2f(0, 1);
    glVertex3f(1, 1, 0);
    glTexCoord2f(1, 1);
    glVertex3f(2.41421F, 1, -1.41421F);
    glTexCoord2f(1, 0);
    glVertex3f(2.41421F, -1, -1.41421F);
    glEnd();
    glFlush();
    glDeleteTextures(1, &name);
}

} // namespace texplorer::programs
