// An animated Earth at one moment: a sphere with lighting and a texture, its axis tilted, its turn so far.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <array>

namespace texplorer::programs {
namespace {

void drawEarth(int width, int height, GLint filter) {
    glClearColor(0, 0, 0.02F, 1);
    glEnable(GL_DEPTH_TEST);

    const Picture& map = pattern("planet");
    GLuint texName = 0;
    glGenTextures(1, &texName);
    glBindTexture(GL_TEXTURE_2D, texName);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, map.width, map.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 map.texels.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_TEXTURE_2D);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, static_cast<double>(width) / height, 4.0 / 50, 4 * 4.0 + 400);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();

    constexpr std::array<GLfloat, 4> sun{-1, 0.3F, 0.8F, 0};
    constexpr std::array<GLfloat, 4> night{0.08F, 0.08F, 0.1F, 1};
    constexpr std::array<GLfloat, 4> surface{1, 1, 1, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, sun.data());
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, night.data());
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, surface.data());
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glTranslatef(0, 0, -4);
    glRotatef(-23.4F, 0, 0, 1); // the tilt of the axis
    glRotatef(32, 0, 1, 0);     // the turn
    glRotatef(-90, 1, 0, 0);    // GLU's axis is z
    GLUquadric* quadric = gluNewQuadric();
    gluQuadricTexture(quadric, GL_TRUE);
    gluSphere(quadric, 1, 64, 32);
    gluDeleteQuadric(quadric);
    glFlush();
    glDeleteTextures(1, &texName);
}

} // namespace

void drawEarthNearest(int width, int height) {
    drawEarth(width, height, GL_NEAREST);
}

void drawEarthLinear(int width, int height) {
    drawEarth(width, height, GL_LINEAR);
}

} // namespace texplorer::programs
