#include "ring.c"

#include <math.h>

/* From y = -1, with the radius 1, to y = 1; s goes around, t upwards. */
static Mesh cylinder(GLfloat topRadius, int slices, int stacks)
{
    Mesh mesh = newMesh(stacks + 1, slices + 1);
    const GLfloat slope = 1 - topRadius;
    const GLfloat length = 1 / sqrtf(2.0f * 2.0f + slope * slope);
    for (int stack = 0; stack <= stacks; ++stack) {
        const GLfloat share = (GLfloat)stack / (GLfloat)stacks;
        ring(&mesh, stack, slices, share, 1 + share * (topRadius - 1), 2 * share - 1, 2 * length, slope * length);
    }
    for (int stack = 0; stack < stacks; ++stack)
        band(&mesh, slices, stack);
    return mesh;
}
