#include "gl.h"

/* When something that moves is what, and how it goes on from there. */
typedef struct {
    GLfloat seconds;
    double (*easing)(double share);
    GLfloat value[4];
} Key;

/* What a component's keys say at a time: between two of them a mixture, before the first what that says, after
 * the last what that says. */
static double track(const Key *keys, int count, double seconds, int component)
{
    int next = 0;
    while (next < count && keys[next].seconds <= seconds)
        ++next;
    if (next == 0 || next == count)
        return keys[next == 0 ? 0 : count - 1].value[component];
    const Key *from = &keys[next - 1], *to = &keys[next];
    const double share = from->easing((seconds - from->seconds) / ((double)to->seconds - from->seconds));
    return from->value[component] * (1 - share) + to->value[component] * share;
}
