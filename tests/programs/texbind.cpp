// texbind.c of the OpenGL Programming Guide: two texture objects, bound one after the other. The environment
// is set once, for it is the unit's.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <array>

namespace texplorer::programs {
namespace {

constexpr int boardSide = 64;
using BoardImage = std::array<std::array<std::array<GLubyte, 4>, boardSide>, boardSide>;

BoardImage makeBoardImage(int square, bool red) {
    BoardImage image;
    for (int i = 0; i < boardSide; ++i)
        for (int j = 0; j < boardSide; ++j) {
            const auto c = static_cast<GLubyte>((((i & square) == 0) != ((j & square) == 0)) ? 255 : 0);
            const GLubyte other = red ? GLubyte{0} : c;
            image[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {c, other, other, 255};
        }
    return image;
}

void makeBoardTexture(GLuint name, const BoardImage& image) {
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, boardSide, boardSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
}

} // namespace

void drawTexbind(int width, int height) {
    glClearColor(0, 0, 0, 0);
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::array<GLuint, 2> texName{};
    glGenTextures(2, texName.data());
    makeBoardTexture(texName[0], makeBoardImage(8, false));
    makeBoardTexture(texName[1], makeBoardImage(16, true));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glEnable(GL_TEXTURE_2D);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(60, static_cast<double>(width) / height, 3.6 / 50, 4 * 3.6 + 400);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3.6F);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBindTexture(GL_TEXTURE_2D, texName[0]);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(-2, -1, 0);
    glTexCoord2f(0, 1);
    glVertex3f(-2, 1, 0);
    glTexCoord2f(1, 1);
    glVertex3f(0, 1, 0);
    glTexCoord2f(1, 0);
    glVertex3f(0, -1, 0);
    glEnd();
    glBindTexture(GL_TEXTURE_2D, texName[1]);
    glBegin(GL_QUADS);
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
    glDeleteTextures(2, texName.data());
}

} // namespace texplorer::programs
