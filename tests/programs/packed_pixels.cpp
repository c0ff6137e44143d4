// Packed pixels as in the OpenGL Programming Guide, "Image Formats": one image in four layouts of memory,
// each packed here by hand.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <array>
#include <cmath>

namespace texplorer::programs {
namespace {

/// The nearest number of so many bits.
unsigned inBits(unsigned byte, unsigned bits) {
    const double most = (1U << bits) - 1;
    return static_cast<unsigned>(std::lround(byte / 255.0 * most));
}

void makeTexture(GLuint name, GLenum format, GLenum type, int width, int height, const void* pixels) {
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, format, type, pixels);
}

void drawSquare(float x, float y) {
    constexpr float half = 0.48F;
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex2f(x - half, y - half);
    glTexCoord2f(1, 0);
    glVertex2f(x + half, y - half);
    glTexCoord2f(1, 1);
    glVertex2f(x + half, y + half);
    glTexCoord2f(0, 1);
    glVertex2f(x - half, y + half);
    glEnd();
}

} // namespace

void drawPackedPixels(int width, int height) {
    const Picture& image = pattern("gradient");
    std::vector<GLushort> bits565;
    std::vector<GLushort> bits4444;
    std::vector<GLubyte> bits332;
    std::vector<GLubyte> blueFirst;
    for (std::size_t i = 0; i + 3 < image.texels.size(); i += 4) {
        const unsigned r = image.texels[i];
        const unsigned g = image.texels[i + 1];
        const unsigned b = image.texels[i + 2];
        const unsigned a = image.texels[i + 3];
        bits565.push_back(static_cast<GLushort>(inBits(r, 5) << 11 | inBits(g, 6) << 5 | inBits(b, 5)));
        bits4444.push_back(
            static_cast<GLushort>(inBits(r, 4) << 12 | inBits(g, 4) << 8 | inBits(b, 4) << 4 | inBits(a, 4)));
        bits332.push_back(static_cast<GLubyte>(inBits(r, 3) << 5 | inBits(g, 3) << 2 | inBits(b, 2)));
        for (const unsigned component : {b, g, r})
            blueFirst.push_back(static_cast<GLubyte>(component));
    }

    glClearColor(0.1F, 0.1F, 0.1F, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::array<GLuint, 4> names{};
    glGenTextures(4, names.data());
    makeTexture(names[0], GL_RGB, GL_UNSIGNED_SHORT_5_6_5, image.width, image.height, bits565.data());
    makeTexture(names[1], GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, image.width, image.height, bits4444.data());
    makeTexture(names[2], GL_RGB, GL_UNSIGNED_BYTE_3_3_2, image.width, image.height, bits332.data());
    makeTexture(names[3], GL_BGR, GL_UNSIGNED_BYTE, image.width, image.height, blueFirst.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    const double top = 3.3 * std::tan(20 * std::acos(-1.0) / 180); // what a view of 40 degrees shows at 3.3
    const double right = top * width / height;
    glOrtho(-right, right, -top, top, -10, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < names.size(); ++i) {
        glBindTexture(GL_TEXTURE_2D, names[i]);
        drawSquare(i % 2 == 0 ? -0.52F : 0.52F, i < 2 ? 0.52F : -0.52F);
    }
    glFlush();
    glDeleteTextures(4, names.data());
}

} // namespace texplorer::programs
