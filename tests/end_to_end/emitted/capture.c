/* Preloaded (LD_PRELOAD) into a program of GLFW and OpenGL, this library shows what the program draws, without a line for
   it in the program. It puts itself in the place of a few functions:

   glfwGetTime        gives the time that is wanted for the frame.
   glfwSwapBuffers    writes the picture that has been drawn into a file and begins the next frame. After the last one it
                      asks the program to close its window, and the program ends by itself, with its own exit status.
   glfwWaitEvents     returns at once: nothing happens that a program could wait for.
   glBindFramebuffer  0 is what is drawn into at the time.

   Mesa keeps a window upside down in memory and a framebuffer object not, so that their pixels differ in the last bits of
   what is interpolated. Therefore a program draws into three framebuffers, one after the other:

     CAPTURE_PICTURES.window   its window
     CAPTURE_PICTURES.turned   a framebuffer object that lies in memory as a window does (GL_MESA_framebuffer_flip_y)
     CAPTURE_PICTURES.0        a framebuffer object like the one that texshot draws into, at the first time
     CAPTURE_PICTURES.1        and at the other times of CAPTURE_TIMES, which has commas between them

   The first two must be the same, and show that the second frame is the same as the first; the others must be those of
   texshot. The files are portable arbitrary maps (PAM) of RGBA, top row first. An error is a line on standard
   error and exit status 70. */

#define _GNU_SOURCE
#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_NONE
#include <GL/gl.h>
#include <GL/glext.h>
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_TIMES = 8, WRONG = 70, WINDOW = 0, TURNED = 1, FIRST_TIME = 2 };

static int frame;
static GLuint framebuffer; /* in the place of the window; 0: it is the window */

static _Noreturn void complain(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fputs("capture: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    _exit(WRONG);
}

static const char* variable(const char* name) {
    const char* value = getenv(name);
    if (!value)
        complain("expected the environment variable %s", name);
    return value;
}

/* How many there are. */
static int readTimes(double times[MAX_TIMES]) {
    const char* text = variable("CAPTURE_TIMES");
    for (int count = 0; count < MAX_TIMES; ++count) {
        char* end = NULL;
        times[count] = strtod(text, &end);
        if (end == text || (*end != ',' && *end != '\0'))
            complain("expected numbers with commas between them in CAPTURE_TIMES, found \"%s\"", text);
        if (*end == '\0')
            return count + 1;
        text = end + 1;
    }
    complain("expected at most %d times in CAPTURE_TIMES", MAX_TIMES);
}

double glfwGetTime(void) {
    double times[MAX_TIMES];
    const int count = readTimes(times);
    const int index = frame < FIRST_TIME ? 0 : frame - FIRST_TIME;
    return times[index < count ? index : count - 1];
}

void glfwWaitEvents(void) {
    glfwPollEvents();
}

void glfwWaitEventsTimeout(double timeout) {
    (void)timeout;
    glfwPollEvents();
}

static void bindFramebuffer(GLenum target, GLuint name) {
    void (*bind)(GLenum, GLuint) = NULL;
    *(void**)&bind = dlsym(RTLD_NEXT, "glBindFramebuffer");
    bind(target, name);
}

void glBindFramebuffer(GLenum target, GLuint name) {
    bindFramebuffer(target, name != 0 ? name : framebuffer);
}

GLFWglproc glfwGetProcAddress(const char* name) {
    GLFWglproc (*find)(const char*) = NULL;
    *(void**)&find = dlsym(RTLD_NEXT, "glfwGetProcAddress");
    return strcmp(name, "glBindFramebuffer") == 0 ? (GLFWglproc)glBindFramebuffer : find(name);
}

static void checkErrors(const char* when) {
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR)
        complain("glGetError says 0x%04X %s of frame %d", error, when, frame);
}

static int isCompatible(void) {
    GLint mask = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    glGetError(); /* before OpenGL 3.2 there are no profiles */
    return (mask & GL_CONTEXT_CORE_PROFILE_BIT) == 0;
}

/* State of glReadPixels, except glPixelTransfer. */
static const GLenum packNames[] = {GL_PACK_SWAP_BYTES,  GL_PACK_LSB_FIRST,    GL_PACK_ROW_LENGTH,  GL_PACK_SKIP_ROWS,
                                   GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES, GL_PACK_ALIGNMENT};
enum { PACKS = sizeof packNames / sizeof packNames[0] };

/* Bottom row first, four bytes for each pixel, in any state of the program; restores the state. */
static void readPixels(int width, int height, unsigned char* pixels) {
    GLint packs[PACKS];
    GLint packBuffer = 0;
    GLint readFramebuffer = 0;
    for (int i = 0; i < PACKS; ++i) {
        glGetIntegerv(packNames[i], &packs[i]);
        glPixelStorei(packNames[i], packNames[i] == GL_PACK_ALIGNMENT ? 1 : 0);
    }
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &packBuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readFramebuffer);
    bindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    if (isCompatible()) {
        static const GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
        static const GLenum biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
        glPushAttrib(GL_PIXEL_MODE_BIT);
        for (int i = 0; i < 4; ++i) {
            glPixelTransferf(scales[i], 1);
            glPixelTransferf(biases[i], 0);
        }
        glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
    }
    GLint readBuffer = 0;
    glGetIntegerv(GL_READ_BUFFER, &readBuffer);
    glReadBuffer(framebuffer != 0 ? GL_COLOR_ATTACHMENT0 : GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    glReadBuffer((GLenum)readBuffer);
    if (isCompatible())
        glPopAttrib();
    bindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)readFramebuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)packBuffer);
    for (int i = 0; i < PACKS; ++i)
        glPixelStorei(packNames[i], packs[i]);
    checkErrors("after reading the picture");
}

static void writePicture(const char* name, int width, int height) {
    char path[4096];
    snprintf(path, sizeof path, "%s.%s", variable("CAPTURE_PICTURES"), name);
    const size_t row = (size_t)width * 4;
    unsigned char* pixels = malloc(row * (size_t)height);
    FILE* file = fopen(path, "wb");
    if (!pixels || !file)
        complain("can't write %s", path);
    readPixels(width, height, pixels);
    fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", width, height);
    for (int y = height - 1; y >= 0; --y)
        fwrite(pixels + row * (size_t)y, 1, row, file);
    if (fclose(file) != 0)
        complain("can't write %s", path);
    free(pixels);
}

/* A framebuffer object in the place of the window, like texshot's: eight bits of each of RGBA, 24 of depth. */
static void makeFramebuffer(int width, int height) {
    GLint renderbuffer = 0;
    GLuint buffers[2];
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer);
    glGenRenderbuffers(2, buffers);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, (GLuint)renderbuffer);
    glGenFramebuffers(1, &framebuffer);
    bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        complain("the driver can't draw into a framebuffer object of %d x %d pixels", width, height);
    checkErrors("after making a framebuffer object");
}

/* Whether the rows of the framebuffer object, which is bound, lie in memory as those of a window. */
static void turn(int isTurned) {
    glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, isTurned);
    if (glGetError() != GL_NO_ERROR)
        complain("the driver lacks GL_MESA_framebuffer_flip_y");
}

void glfwSwapBuffers(GLFWwindow* window) {
    double times[MAX_TIMES];
    const int count = readTimes(times);
    if (frame == FIRST_TIME + count)
        complain("the program draws on when its window is to be closed");
    checkErrors("at the end");
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    char name[16] = "window";
    if (frame == TURNED)
        strcpy(name, "turned");
    else if (frame >= FIRST_TIME)
        snprintf(name, sizeof name, "%d", frame - FIRST_TIME);
    writePicture(name, width, height);
    ++frame;
    if (frame == FIRST_TIME + count) {
        glfwSetWindowShouldClose(window, GLFW_TRUE);
        return;
    }
    if (frame == TURNED)
        makeFramebuffer(width, height);
    if (frame == TURNED || frame == FIRST_TIME)
        turn(frame == TURNED);
}
