// A peer of the reference renderer: one of Mesa's drivers, which GALLIUM_DRIVER chooses once for a whole
// process. Draws a frame for every byte that it reads and says how long it took.

#include "app/offscreen/osmesa_context.h"
#include "app/render/fixed_renderer.h"
#include "core/scene/image_source.h"
#include "tests/bench/frame_scenes.h"

#include <GL/glew.h>

#include <chrono>
#include <cstdio>
#include <ctime>

namespace {

using namespace texplorer;

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

double clockSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    const auto scene = bench::frameScene(argv[1], argv[2]);
    const auto context = offscreen::OsmesaContext::create({1, 1});
    auto renderer = render::loadCapabilities().and_then(&render::FixedRenderer::create);
    if (!scene || !context || !renderer)
        return 1;
    const ImageSource images;
    const auto draw = [&] {
        const auto drawn = renderer->draw(*scene, images, 0, {bench::frameWidth, bench::frameHeight});
        glFinish();
        return drawn && drawn->problems.empty();
    };
    if (!draw() || !draw()) // textures and compiled state
        return 1;
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    std::fflush(stdout);
    while (std::getchar() != EOF) {
        const double clock = clockSeconds();
        const double processor = processorSeconds();
        draw();
        std::printf("%.9f %.9f\n", clockSeconds() - clock, processorSeconds() - processor);
        std::fflush(stdout);
    }
    return 0;
}
