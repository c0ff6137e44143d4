#include "ring.c"

/* A ring of radius 1 around the y axis; s goes around it, t around its tube. */
static Mesh torus(GLfloat tubeRadius, int slices, int stacks)
{
    Mesh mesh = newMesh(stacks + 1, slices + 1);
    for (int stack = 0; stack <= stacks; ++stack) {
        GLfloat sine, cosine;
        circle(4.0 * stack / stacks, &sine, &cosine);
        ring(&mesh, stack, slices, (GLfloat)stack / (GLfloat)stacks, 1 - tubeRadius * cosine, -tubeRadius * sine,
             -cosine, -sine);
    }
    for (int stack = 0; stack < stacks; ++stack)
        band(&mesh, slices, stack);
    return mesh;
}
