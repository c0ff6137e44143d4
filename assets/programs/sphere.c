#include "ring.c"

/* Radius 1; s goes around, t from the south pole to the north pole. */
static Mesh sphere(int slices, int stacks)
{
    Mesh mesh = newMesh(stacks + 1, slices + 1);
    for (int stack = 0; stack <= stacks; ++stack) {
        GLfloat sine, cosine;
        circle(2.0 * stack / stacks, &sine, &cosine);
        ring(&mesh, stack, slices, (GLfloat)stack / (GLfloat)stacks, sine, -cosine, sine, -cosine);
    }
    for (int stack = stacks - 1; stack >= 0; --stack)
        band(&mesh, slices, stack);
    return mesh;
}
