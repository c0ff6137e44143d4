/* Preloaded (LD_PRELOAD) into texplorer, this library is a driver that hangs while it draws a scene with a certain
 * background:
 *
 *   HANGS_WHILE=FILE   it hangs while this file exists
 *   HANGS_ALWAYS=1     it also hangs in the panels, which are the first to be drawn without it
 *   HANGS_CLOSING=1    it also hangs when it frees a texture
 *   HANGS_SAID=FILE    a line for each time that it hangs
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void *driver_function(const char *name) {
    static const char *libraries[] = {"libGL.so.1", "libOpenGL.so.0"};
    for (int i = 0; i < 2; ++i) {
        void *library = dlopen(libraries[i], RTLD_LAZY | RTLD_NOLOAD);
        void *found = library ? dlsym(library, name) : NULL;
        if (found)
            return found;
    }
    abort();
}

static void hang(const char *where) {
    FILE *file = fopen(getenv("HANGS_SAID"), "a");
    fprintf(file, "%s\n", where);
    fclose(file);
    while (access(getenv("HANGS_WHILE"), F_OK) == 0)
        usleep(10000);
}

static int is_like(float a, float b) {
    return a > b - 0.001f && a < b + 0.001f;
}

/* 13/16, 3/16 and 7/16: see HANGING in hang_test.py. */
static int is_hanging_background(float red, float green, float blue) {
    return is_like(red, 0.8125f) && is_like(green, 0.1875f) && is_like(blue, 0.4375f);
}

void glClearColor(float red, float green, float blue, float alpha) {
    const char *always = getenv("HANGS_ALWAYS");
    if (access(getenv("HANGS_WHILE"), F_OK) == 0) {
        if (is_hanging_background(red, green, blue))
            hang("scene");
        if (always && access(getenv("HANGS_SAID"), F_OK) == 0)
            hang("panels");
    }
    ((void (*)(float, float, float, float))driver_function("glClearColor"))(red, green, blue, alpha);
}

void glDeleteTextures(int count, const unsigned *names) {
    if (getenv("HANGS_CLOSING") && access(getenv("HANGS_WHILE"), F_OK) == 0)
        hang("closing");
    ((void (*)(int, const unsigned *))driver_function("glDeleteTextures"))(count, names);
}
