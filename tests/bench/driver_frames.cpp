// A peer of the reference renderer: one of Mesa's drivers, which GALLIUM_DRIVER chooses once for a whole
// process. Says which driver it got; then, for every line with the names of a scene and of a filter, draws a
// frame and says how many seconds of the processor's time it took, all threads together.

#include "app/offscreen/context.h"
#include "app/render/fixed_renderer.h"
#include "tests/bench/frame_scenes.h"
#include "texplorer/texture/image_source.h"

#include <GL/glew.h>

#include <ctime>
#include <iostream>
#include <string>

namespace {

using namespace texplorer;

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

} // namespace

int main() {
    const auto context = offscreen::Context::create({1, 1});
    auto renderer = render::loadCapabilities().and_then(&render::FixedRenderer::create);
    if (!context || !renderer)
        return 1;
    std::cout << reinterpret_cast<const char*>(glGetString(GL_RENDERER)) << std::endl;

    const ImageSource images;
    std::string sceneName;
    std::string filterName;
    std::optional<Scene> drawn;
    while (std::cin >> sceneName >> filterName) {
        const std::optional<Scene> scene = bench::frameScene(sceneName, filterName);
        if (!scene)
            return 1;
        const auto draw = [&] {
            const auto frame = renderer->draw(*scene, images, 0, {bench::frameWidth, bench::frameHeight});
            glFinish();
            return frame && frame->problems.empty();
        };
        if (drawn != scene && !draw()) // a first time: textures, compiled state
            return 1;
        drawn = scene;
        const double before = processorSeconds();
        draw();
        std::cout << processorSeconds() - before << std::endl;
    }
    return 0;
}
