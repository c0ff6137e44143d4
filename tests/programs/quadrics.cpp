// GLU's quadrics with texture coordinates of GLU's own: a sphere, a cylinder, a disk and a part of one, lit.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <array>

namespace texplorer::programs {
namespace {

/// A texture object with all its mip levels.
GLuint makeQuadricTexture(const Picture& picture) {
    GLuint texName = 0;
    glGenTextures(1, &texName);
    glBindTexture(GL_TEXTURE_2D, texName);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      picture.texels.data());
    return texName;
}

void lightQuadrics() {
    constexpr std::array<GLfloat, 4> position{0.4F, 0.7F, 1, 0};
    constexpr std::array<GLfloat, 4> white{1, 1, 1, 1};
    constexpr std::array<GLfloat, 4> grey{0.5F, 0.5F, 0.5F, 1};
    glLightfv(GL_LIGHT0, GL_POSITION, position.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, grey.data());
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32);
    glEnable(GL_LIGHT0);
    glEnable(GL_LIGHTING);
}

} // namespace

void drawQuadrics(int width, int height) {
    glClearColor(0.11F, 0.13F, 0.16F, 1);
    glEnable(GL_DEPTH_TEST);
    const GLuint texName = makeQuadricTexture(pattern("uv-template"));
    glEnable(GL_TEXTURE_2D);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, static_cast<double>(width) / height, 7.0 / 50, 4 * 7.0 + 400);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    lightQuadrics(); // while the matrix is the identity: the light is next to the eye
    glTranslatef(0, 0, -7);
    glRotatef(15, 1, 0, 0);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    GLUquadric* quadric = gluNewQuadric();
    gluQuadricTexture(quadric, GL_TRUE);

    glPushMatrix();
    glTranslatef(-1.3F, 1.05F, 0);
    glRotatef(-90, 1, 0, 0); // GLU's axis is z
    gluSphere(quadric, 1, 32, 16);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(1.3F, 0.05F, 0);
    glRotatef(-90, 1, 0, 0);
    gluCylinder(quadric, 1, 1, 2, 32, 4);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(-1.3F, -1.35F, 0);
    gluDisk(quadric, 0.3, 1, 32, 4);
    glPopMatrix();

    glPushMatrix();
    glTranslatef(1.3F, -1.35F, 0);
    gluPartialDisk(quadric, 0.3, 1, 32, 4, 0, 240);
    glPopMatrix();

    gluDeleteQuadric(quadric);
    glFlush();
    glDeleteTextures(1, &texName);
}

} // namespace texplorer::programs
