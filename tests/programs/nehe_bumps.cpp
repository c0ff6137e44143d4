// NeHe's lesson 22: an embossed cube in three passes, or in two with two texture units, or a plain one; and
// two logos before the eye.

#include "tests/programs/programs.h"

#include <GL/glew.h>
#include <GL/glu.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::programs {
namespace {

constexpr GLfloat maxEmboss = 0.008F;
constexpr std::array<GLfloat, 4> lightPosition{0, 0, 2, 1};
constexpr GLfloat z = -5;
constexpr GLfloat xrot = 25;
constexpr GLfloat yrot = -35;

// Texture coordinates, then the place: six faces of four corners.
constexpr std::array<GLfloat, 120> data{
    // front
    0, 0, -1, -1, +1, //
    1, 0, +1, -1, +1, //
    1, 1, +1, +1, +1, //
    0, 1, -1, +1, +1, //
    // back
    1, 0, -1, -1, -1, //
    1, 1, -1, +1, -1, //
    0, 1, +1, +1, -1, //
    0, 0, +1, -1, -1, //
    // top
    0, 1, -1, +1, -1, //
    0, 0, -1, +1, +1, //
    1, 0, +1, +1, +1, //
    1, 1, +1, +1, -1, //
    // bottom
    1, 1, -1, -1, -1, //
    0, 1, +1, -1, -1, //
    0, 0, +1, -1, +1, //
    1, 0, -1, -1, +1, //
    // right
    1, 0, +1, -1, -1, //
    1, 1, +1, +1, -1, //
    0, 1, +1, +1, +1, //
    0, 0, +1, -1, +1, //
    // left
    0, 0, -1, -1, -1, //
    1, 0, -1, -1, +1, //
    1, 1, -1, +1, +1, //
    0, 1, -1, +1, -1, //
};

struct NeheFace {
    std::array<GLfloat, 3> n; ///< the normal
    std::array<GLfloat, 3> s; ///< where s and t grow
    std::array<GLfloat, 3> t;
};
constexpr std::array<NeheFace, 6> neheFaces{{
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
    {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}},
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
}};

struct NeheTextures {
    GLuint texture = 0;
    GLuint bump = 0;
    GLuint invbump = 0;
    GLuint glLogo = 0;
    GLuint multiLogo = 0;
};

GLuint makeNeheTexture(const Picture& picture, GLint internalFormat) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, picture.width, picture.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, picture.texels.data());
    return name;
}

NeheTextures loadGLTextures() {
    NeheTextures made;
    made.texture = makeNeheTexture(pattern("brick"), GL_RGB8);

    for (const GLenum scale : std::array<GLenum, 3>{GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE})
        glPixelTransferf(scale, 0.5F); // half the heights, and half of their inverse: together 1
    Picture bumps = pattern("brick-height");
    made.bump = makeNeheTexture(bumps, GL_RGB8);
    std::ranges::transform(bumps.texels, bumps.texels.begin(),
                           [](std::uint8_t height) { return static_cast<std::uint8_t>(255 - height); });
    made.invbump = makeNeheTexture(bumps, GL_RGB8);
    for (const GLenum scale : std::array<GLenum, 3>{GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE})
        glPixelTransferf(scale, 1);

    made.glLogo = makeNeheTexture(pattern("logo-opengl"), GL_RGBA8);
    made.multiLogo = makeNeheTexture(pattern("logo-multitexture"), GL_RGBA8);
    return made;
}

void deleteGLTextures(const NeheTextures& made) {
    for (const GLuint name : {made.texture, made.bump, made.invbump, made.glLogo, made.multiLogo})
        glDeleteTextures(1, &name);
}

void initNehe(int width, int height) {
    glClearColor(0, 0, 0, 0);
    glClearDepth(1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    constexpr std::array<GLfloat, 4> ambient{0.2F, 0.2F, 0.2F, 1};
    constexpr std::array<GLfloat, 4> diffuse{1, 1, 1, 1};
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glLightfv(GL_LIGHT1, GL_AMBIENT, ambient.data());
    glLightfv(GL_LIGHT1, GL_DIFFUSE, diffuse.data());
    glLightfv(GL_LIGHT1, GL_POSITION, lightPosition.data());
    glEnable(GL_LIGHT1);

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(45, static_cast<double>(width) / height, 0.1, 4 * 5.0 + 400);
    glMatrixMode(GL_MODELVIEW);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

using Vector = std::array<GLfloat, 4>;

/// As the document has it, the row times the matrix: what a matrix that moves nothing does transposed.
Vector vMatMult(const std::array<GLfloat, 16>& m, const Vector& v) {
    return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3] * v[3],
            m[4] * v[0] + m[5] * v[1] + m[6] * v[2] + m[7] * v[3],
            m[8] * v[0] + m[9] * v[1] + m[10] * v[2] + m[11] * v[3], m[15]};
}

/// The light as the cube has it. Leaves the cube's matrix.
Vector placeCube() {
    std::array<GLfloat, 16> minv{};
    glLoadIdentity();
    glRotatef(-yrot, 0, 1, 0);
    glRotatef(-xrot, 1, 0, 0);
    glTranslatef(0, 0, -z);
    glGetFloatv(GL_MODELVIEW_MATRIX, minv.data());
    glLoadIdentity();
    glTranslatef(0, 0, z);
    glRotatef(xrot, 1, 0, 0);
    glRotatef(yrot, 0, 1, 0);
    return vMatMult(minv, lightPosition);
}

struct Offset {
    GLfloat s;
    GLfloat t;
};

Offset setUpBumps(const NeheFace& face, const GLfloat* c, const Vector& l) {
    std::array<GLfloat, 3> v{l[0] - c[0], l[1] - c[1], l[2] - c[2]};
    const GLfloat length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (GLfloat& each : v)
        each /= length;
    return {(face.s[0] * v[0] + face.s[1] * v[1] + face.s[2] * v[2]) * maxEmboss,
            (face.t[0] * v[0] + face.t[1] * v[1] + face.t[2] * v[2]) * maxEmboss};
}

/// OpenGL leaves it open how a quadrilateral is divided, and the light's colours and the moved coordinates
/// show it. In a display list Mesa divides as our meshes do: see core/mesh/mesh.h.
class QuadList {
public:
    QuadList() { glNewList(name_, GL_COMPILE); }
    QuadList(const QuadList&) = delete;
    QuadList& operator=(const QuadList&) = delete;
    ~QuadList() {
        glEndList();
        glCallList(name_);
        glDeleteLists(name_, 1);
    }

private:
    GLuint name_ = glGenLists(1);
};

void doCube() {
    const QuadList list;
    glBegin(GL_QUADS);
    for (std::size_t i = 0; i < data.size(); i += 5) {
        glNormal3fv(neheFaces[i / 20].n.data());
        glTexCoord2fv(&data[i]);
        glVertex3fv(&data[i + 2]);
    }
    glEnd();
}

/// With the coordinates of one unit, or of both, moved towards the light.
void doBumpCube(const Vector& l, bool firstStays) {
    const QuadList list;
    glBegin(GL_QUADS);
    for (std::size_t i = 0; i < data.size(); i += 5) {
        const Offset moved = setUpBumps(neheFaces[i / 20], &data[i + 2], l);
        const GLfloat s = data[i] + moved.s;
        const GLfloat t = data[i + 1] + moved.t;
        if (firstStays) {
            glMultiTexCoord2f(GL_TEXTURE0, data[i], data[i + 1]);
            glMultiTexCoord2f(GL_TEXTURE1, s, t);
        } else {
            glTexCoord2f(s, t);
        }
        glVertex3fv(&data[i + 2]);
    }
    glEnd();
}

/// What is there, times the lit wall, times 2.
void doLitPass(const NeheTextures& textures) {
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glBindTexture(GL_TEXTURE_2D, textures.texture);
    glBlendFunc(GL_DST_COLOR, GL_SRC_COLOR);
    glEnable(GL_BLEND);
    glEnable(GL_LIGHTING);
    doCube();
}

void doMesh1TexelUnits(const NeheTextures& textures) {
    const Vector l = placeCube();
    glBindTexture(GL_TEXTURE_2D, textures.bump);
    glDisable(GL_BLEND);
    glDisable(GL_LIGHTING);
    doCube();
    glBindTexture(GL_TEXTURE_2D, textures.invbump);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_BLEND);
    doBumpCube(l, false);
    doLitPass(textures);
}

void doMesh2TexelUnits(const NeheTextures& textures) {
    const Vector l = placeCube();
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, textures.bump);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvf(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glActiveTexture(GL_TEXTURE1);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, textures.invbump);
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvf(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD);
    glDisable(GL_BLEND);
    glDisable(GL_LIGHTING);
    doBumpCube(l, true);

    glActiveTexture(GL_TEXTURE1);
    glDisable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
    doLitPass(textures);
}

void doMeshNoBumps(const NeheTextures& textures) {
    placeCube();
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, textures.texture);
    glEnable(GL_LIGHTING);
    doCube();
}

void doLogo(GLuint name, GLfloat left, GLfloat right, GLfloat bottom, GLfloat top) {
    glBindTexture(GL_TEXTURE_2D, name);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0);
    glVertex3f(left, bottom, -1);
    glTexCoord2f(1, 0);
    glVertex3f(right, bottom, -1);
    glTexCoord2f(1, 1);
    glVertex3f(right, top, -1);
    glTexCoord2f(0, 1);
    glVertex3f(left, top, -1);
    glEnd();
}

void doLogos(const NeheTextures& textures) {
    glDepthFunc(GL_ALWAYS);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_BLEND);
    glDisable(GL_LIGHTING);
    glLoadIdentity();
    doLogo(textures.glLogo, 0.23F, 0.53F, -0.4F, -0.25F);
    doLogo(textures.multiLogo, -0.53F, -0.33F, -0.25F, -0.15F);
    glDepthFunc(GL_LEQUAL);
}

void drawNehe(int width, int height, void (*doMesh)(const NeheTextures& textures)) {
    const NeheTextures textures = loadGLTextures();
    initNehe(width, height);
    glEnable(GL_TEXTURE_2D);
    doMesh(textures);
    doLogos(textures);
    glFlush();
    deleteGLTextures(textures);
}

} // namespace

void drawNeheNoBumps(int width, int height) {
    drawNehe(width, height, doMeshNoBumps);
}

void drawNeheBumpsOneUnit(int width, int height) {
    drawNehe(width, height, doMesh1TexelUnits);
}

void drawNeheBumpsTwoUnits(int width, int height) {
    drawNehe(width, height, doMesh2TexelUnits);
}

} // namespace texplorer::programs
