#include "gl.h"

/* When a name or a switch is what. */
typedef struct {
    GLfloat seconds;
    GLenum value;
} Step;

/* Nothing lies between two names or switches: each holds until the next one comes. */
static GLenum step(const Step *steps, int count, double seconds)
{
    int i = 0;
    while (i + 1 < count && steps[i + 1].seconds <= seconds)
        ++i;
    return steps[i].value;
}
