#include "gl.h"

#include <math.h>

/* Moves coordinates towards the light, vertex by vertex, along the directions in which s and t grow (`tangents`,
 * six numbers each): after NeHe's lesson 22. */
static void emboss(int count, const GLfloat *positions, const GLfloat *coords, const GLfloat *tangents,
                   const GLfloat light[4], GLfloat depth, GLfloat *moved)
{
    for (int i = 0; i < count; ++i) {
        const GLfloat *position = positions + 3 * i;
        const GLfloat *coord = coords + 4 * i;
        GLfloat to[3], offset[2] = {0, 0};
        for (int k = 0; k < 3; ++k)
            to[k] = light[k] - light[3] * position[k];
        const GLfloat length = sqrtf(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
        for (int k = 0; k < 3 && length > 0; ++k) {
            offset[0] += tangents[6 * i + k] * (to[k] / length);
            offset[1] += tangents[6 * i + 3 + k] * (to[k] / length);
        }
        moved[4 * i] = coord[0] + offset[0] * depth * coord[3];
        moved[4 * i + 1] = coord[1] + offset[1] * depth * coord[3];
        moved[4 * i + 2] = coord[2];
        moved[4 * i + 3] = coord[3];
    }
}
