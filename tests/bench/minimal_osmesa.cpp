// The peer of `texshot shot`: the least that an OSMesa program can do. A context, one quad, and out.

#include <GL/osmesa.h>

#include <cstdlib>
#include <vector>

int main(int argc, char** argv) {
    const int width = argc > 2 ? std::atoi(argv[1]) : 1280;
    const int height = argc > 2 ? std::atoi(argv[2]) : 800;
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    if (!context || !OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height))
        return 1;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_QUADS);
    glVertex2f(-0.5F, -0.5F);
    glVertex2f(0.5F, -0.5F);
    glVertex2f(0.5F, 0.5F);
    glVertex2f(-0.5F, 0.5F);
    glEnd();
    glFinish();
    OSMesaDestroyContext(context);
    return 0;
}
