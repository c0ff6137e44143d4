#include "gl.h"

/* Where the light is as the model has it, by the inverse of the modelview matrix; transposed: by the transpose
 * of its rotation and scale, as one gets it who multiplies the row. */
static void lightInModel(const double modelView[16], const GLfloat light[4], int transposed, GLfloat found[4])
{
    double m[16], inverse[9], eye[3];
    for (int i = 0; i < 16; ++i)
        m[i] = (GLfloat)modelView[i];
    const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
                               m[8] * (m[1] * m[6] - m[2] * m[5]);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double *a = m + 4 * ((row + 1) % 3);
            const double *b = m + 4 * ((row + 2) % 3);
            const int i = (column + 1) % 3;
            const int j = (column + 2) % 3;
            inverse[3 * row + column] = (a[i] * b[j] - a[j] * b[i]) / determinant;
        }
    }
    for (int i = 0; i < 3; ++i)
        eye[i] = (double)light[i] / (light[3] != 0 ? light[3] : 1) - (light[3] != 0 && !transposed ? m[12 + i] : 0);
    for (int i = 0; i < 3; ++i) {
        double sum = 0;
        for (int j = 0; j < 3; ++j)
            sum += (transposed ? inverse[3 * j + i] : inverse[3 * i + j]) * eye[j];
        found[i] = (GLfloat)sum;
    }
    found[3] = light[3] != 0 ? 1 : 0;
}
