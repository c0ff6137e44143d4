#include "core/emit/matrix_functions.h"

namespace texplorer::emit {

const std::string_view matrixText =
    R"(/* A matrix, column by column as OpenGL has it. It is made in doubles, so that what turns for hours turns smoothly,
 * and rounded for the shader. */
typedef struct {
    double at[16];
} Matrix;

/* What b does, then what a does. */
static Matrix multiply(Matrix a, Matrix b)
{
    Matrix product;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            double sum = 0;
            for (int i = 0; i < 4; ++i)
                sum += a.at[4 * i + row] * b.at[4 * column + i];
            product.at[4 * column + row] = sum;
        }
    }
    return product;
}
)";

const std::string_view degreeText =
    R"(/* In radians, which C takes. */
static const double degree = 3.14159265358979323846 / 180;
)";

const std::string_view identityText =
    R"(/* What changes nothing. */
static const Matrix identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
)";

const std::string_view translationText =
    R"(/* As glTranslate. */
static Matrix translation(double x, double y, double z)
{
    const Matrix matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}};
    return matrix;
}
)";

const std::string_view rotationText =
    R"(/* As glRotate; right angles are exact. */
static Matrix rotation(double degrees, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    const double turn = length > 0 ? remainder(degrees, 360.0) : 0; /* without an axis nothing turns */
    double sine = sin(turn * degree);
    double cosine = cos(turn * degree);
    if (remainder(turn, 90.0) == 0) {
        sine = round(sine);
        cosine = round(cosine);
    }
    if (length > 0) {
        x /= length;
        y /= length;
        z /= length;
    }
    const double rest = 1 - cosine;
    const Matrix matrix = {{rest * x * x + cosine, rest * x * y + sine * z, rest * x * z - sine * y, 0,
                            rest * y * x - sine * z, rest * y * y + cosine, rest * y * z + sine * x, 0,
                            rest * z * x + sine * y, rest * z * y - sine * x, rest * z * z + cosine, 0,
                            0, 0, 0, 1}};
    return matrix;
}
)";

const std::string_view scalingText =
    R"(/* As glScale. */
static Matrix scaling(double x, double y, double z)
{
    const Matrix matrix = {{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}};
    return matrix;
}
)";

const std::string_view aboutText =
    R"(/* What turns or scales about the origin does so about a point. */
static Matrix about(double x, double y, double z, Matrix matrix)
{
    return multiply(multiply(translation(x, y, z), matrix), translation(-x, -y, -z));
}
)";

const std::string_view frustumText =
    R"(/* As gluPerspective: the angle is vertical, in degrees. */
static Matrix perspective(double angle, double aspect, double nearest, double farthest)
{
    const double top = nearest * tan(angle * degree / 2);
    const double right = top * aspect;
    const Matrix matrix = {{nearest / right, 0, 0, 0, 0, nearest / top, 0, 0,
                            0, 0, -(farthest + nearest) / (farthest - nearest), -1,
                            0, 0, -2 * farthest * nearest / (farthest - nearest), 0}};
    return matrix;
}
)";

const std::string_view orthographicText =
    R"(/* As glOrtho with the eye in the middle: what is behind it is in sight, too. */
static Matrix orthographic(double right, double top, double farthest)
{
    return scaling(1 / right, 1 / top, -1 / farthest);
}
)";

const std::string_view floatProductText =
    R"(/* The product as a shader would make it, in floats. */
static Matrix multiplyFloats(Matrix a, Matrix b)
{
    Matrix product;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            GLfloat sum = 0;
            for (int i = 0; i < 4; ++i)
                sum += (GLfloat)a.at[4 * i + row] * (GLfloat)b.at[4 * column + i];
            product.at[4 * column + row] = sum;
        }
    }
    return product;
}
)";

const std::string_view setMatrixText =
    R"(/* Shaders take floats. */
static void setMatrix(GLuint program, const char *name, Matrix matrix)
{
    GLfloat floats[16];
    for (int i = 0; i < 16; ++i)
        floats[i] = (GLfloat)matrix.at[i];
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, floats);
}
)";

const std::string_view setNormalMatrixText =
    R"(/* What normals are multiplied by: the inverse of the rotation and scale, transposed, by Cramer's rule. */
static void setNormalMatrix(GLuint program, const char *name, Matrix modelView)
{
    GLfloat m[3][3], normal[9];
    for (int i = 0; i < 9; ++i)
        m[i / 3][i % 3] = (GLfloat)modelView.at[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            normal[3 * i + j] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                                m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
    }
    const GLfloat determinant = m[0][0] * normal[0] + m[1][0] * normal[3] + m[2][0] * normal[6];
    for (int i = 0; i < 9; ++i)
        normal[i] *= 1 / determinant;
    glUniformMatrix3fv(glGetUniformLocation(program, name), 1, GL_FALSE, normal);
}
)";

const std::string_view compileText =
    R"(/* Compiles one stage; what the driver has against it is printed. */
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
    const GLuint program = glCreateProgram();
    const GLuint stages[] = {compile(GL_VERTEX_SHADER, vertexShader), compile(GL_FRAGMENT_SHADER, fragmentShader)};
    GLint done = GL_FALSE;
    for (int i = 0; i < 2; ++i) {
        glAttachShader(program, stages[i]);
        glDeleteShader(stages[i]); /* when the program doesn't need it any more */
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) {
        char log[4096];
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        fprintf(stderr, "The shaders can't be linked:\n%s\n", log);
        exit(EXIT_FAILURE);
    }
    return program;
}
)";

const std::string_view bufferText =
    R"(/* A new buffer, bound to the target, with a copy of the bytes. */
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
)";

} // namespace texplorer::emit
