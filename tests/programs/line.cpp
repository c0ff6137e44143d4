// Textures along lines, as Hearn and Baker's "Computer Graphics with OpenGL" has them: a one-dimensional
// array of colours, and a coordinate s at each end.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <array>
#include <cmath>
#include <numbers>

namespace texplorer::programs {
namespace {

constexpr int nTexColors = 8;

/// 4 * nTexColors elements.
constexpr std::array<GLubyte, std::size_t{4} * nTexColors> lineTexArray{
    255, 0, 0,   255, 255, 255, 0,   255, 0,   255, 0,   255, 0, 255, 255, 255, // red, yellow, green, cyan
    0,   0, 255, 255, 255, 0,   255, 255, 255, 255, 255, 255, 0, 0,   0,   255, // blue, magenta, white, black
};

/// The view of both programs, and the texture, which the caller deletes.
GLuint beginLines(int width, int height) {
    GLuint texName = 0;
    glGenTextures(1, &texName);
    glBindTexture(GL_TEXTURE_1D, texName);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, nTexColors, 0, GL_RGBA, GL_UNSIGNED_BYTE, lineTexArray.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_1D);
    glEnable(GL_DEPTH_TEST);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, static_cast<double>(width) / height, 3.0 / 50, 4 * 3.0 + 400);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0, 0, -3);
    glClearColor(0.25F, 0.28F, 0.33F, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return texName;
}

} // namespace

void drawLine(int width, int height) {
    const GLuint texName = beginLines(width, height);
    glLineWidth(15);
    glBegin(GL_LINES);
    glTexCoord1f(0); // the whole texture
    glVertex3f(-1.21F, -0.23F, 0);
    glTexCoord1f(1);
    glVertex3f(1.19F, 0.87F, 0);

    glTexCoord1f(0); // three copies of it
    glVertex3f(-1.21F, -0.55F, 0);
    glTexCoord1f(3);
    glVertex3f(1.19F, 0.55F, 0);

    glTexCoord1f(0.25F); // a run of its colours
    glVertex3f(-1.21F, -0.87F, 0);
    glTexCoord1f(0.75F);
    glVertex3f(1.19F, 0.23F, 0);
    glEnd();
    glFlush();
    glDeleteTextures(1, &texName);
}

void drawSpiral(int width, int height) {
    constexpr int turns = 5;
    constexpr int steps = 32; // a turn
    const GLuint texName = beginLines(width, height);
    glLineWidth(7);
    glBegin(GL_LINE_STRIP);
    for (int i = 0; i <= turns * steps; ++i) {
        const double way = static_cast<double>(i) / (turns * steps);
        const double angle = 2 * std::numbers::pi * turns * way;
        glTexCoord1f(static_cast<float>(12 * way * way)); // the spiral's length grows as this does
        glVertex3f(static_cast<float>(way * std::sin(angle)), static_cast<float>(way * std::cos(angle)), 0);
    }
    glEnd();
    glFlush();
    glDeleteTextures(1, &texName);
}

} // namespace texplorer::programs
