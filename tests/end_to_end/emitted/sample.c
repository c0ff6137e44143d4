/* A program as "texshot emit" writes them, small and by hand: two quads, one of which turns by 90 degrees in a second. What
   FAULT is defined as goes wrong.
   cc -std=c99 sample.c -o sample -lglfw -lGL */

#include <GLFW/glfw3.h>
#include <stdio.h>
#include <stdlib.h>

enum { NONE, PIXEL, CRASH, NEVER_SWAPS, ENDS_AT_ONCE, WRONG_ENUM, LEFTOVER, ONLY_THE_WINDOW, STAYS_OPEN, TALKS, FAILS_AT_THE_END };
#ifndef FAULT
#define FAULT NONE
#endif

static void drawQuad(void) {
    glBegin(GL_QUADS);
    glVertex2f(-0.5f, -0.5f);
    glVertex2f(0.5f, -0.5f);
    glVertex2f(0.5f, 0.5f);
    glVertex2f(-0.5f, 0.5f);
    glEnd();
}

static void draw(double seconds) {
    glClearColor(0.0f, 0.2f, 0.4f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_MODELVIEW);
    if (FAULT != LEFTOVER)
        glLoadIdentity();
    glTranslatef(-0.5f, 0.0f, 0.0f);
    glScalef(0.5f, 0.5f, 1.0f);
    glColor3f(1.0f, 0.6f, 0.0f);
    drawQuad();
    glTranslatef(2.0f, 0.0f, 0.0f);
    glRotatef(90.0f * (float)seconds, 0.0f, 0.0f, 1.0f);
    glScalef(1.0f, 2.0f, 1.0f);
    glColor3f(0.2f, 1.0f, 0.2f);
    drawQuad();
    glLoadIdentity();
    if (FAULT == PIXEL) {
        glColor3f(1.0f, 0.6f, 0.2f);
        glBegin(GL_POINTS);
        glVertex2f(-0.5f + 1.0f / 640, 1.0f / 480);
        glEnd();
    }
    if (FAULT == LEFTOVER)
        glTranslatef(0.1f, 0.0f, 0.0f);
    if (FAULT == WRONG_ENUM)
        glEnable(GL_MODULATE);
}

int main(void) {
    if (FAULT == TALKS)
        fprintf(stderr, "something is odd\n");
    if (FAULT == ENDS_AT_ONCE || !glfwInit())
        return 0;
    GLFWwindow* window = glfwCreateWindow(640, 480, "sample", NULL, NULL);
    if (!window)
        return 1;
    glfwMakeContextCurrent(window);
    if (FAULT == CRASH)
        abort();
    for (int frame = 0; !glfwWindowShouldClose(window) || FAULT == STAYS_OPEN; ++frame) {
        int width, height;
        glfwGetFramebufferSize(window, &width, &height);
        glViewport(0, 0, width, height);
        if (FAULT != ONLY_THE_WINDOW || frame == 0)
            draw(glfwGetTime());
        while (FAULT == NEVER_SWAPS)
            glfwPollEvents();
        glfwSwapBuffers(window);
        glfwWaitEvents();
    }
    glfwTerminate();
    return FAULT == FAILS_AT_THE_END ? 3 : 0;
}
