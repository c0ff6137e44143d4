// checker.c of the OpenGL Programming Guide: a board that it computes itself, on two squares.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <array>

namespace texplorer::programs {
namespace {

constexpr int checkerSide = 64;
using CheckerImage = std::array<std::array<std::array<GLubyte, 4>, checkerSide>, checkerSide>;

CheckerImage makeCheckerImage() {
    CheckerImage image;
    for (int i = 0; i < checkerSide; ++i)
        for (int j = 0; j < checkerSide; ++j) {
            const auto c = static_cast<GLubyte>((((i & 8) == 0) != ((j & 8) == 0)) ? 255 : 0);
            image[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {c, c, c, 255};
        }
    return image;
}

} // namespace

void drawChecker(int width, int height) {
    glClearColor(0, 0, 0, 0);
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    const CheckerImage image = makeCheckerImage();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    GLuint texName = 0;
    glGenTextures(1, &texName);
    glBindTexture(GL_TEXTURE_2D, texName);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, checkerSide, checkerSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.data());

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, static_cast<double>(width) / height, 3.6 / 50, 4 * 3.6 + 400);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3.6F);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glBindTexture(GL_TEXTURE_2D, texName);
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
    glDisable(GL_TEXTURE_2D);
    glDeleteTextures(1, &texName);
}

} // namespace texplorer::programs
