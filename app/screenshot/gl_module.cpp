// The GL half of texshot: OSMesa, the renderer and, for --ui, the panels.

#include "app/screenshot/gl_module.h"

#include "app/offscreen/osmesa_context.h"
#include "app/render/capabilities.h"
#include "app/render/driver_facts.h"
#include "app/render/shader_renderer.h"
#include "app/stage/stage.h"
#include "app/ui/session.h"
#include "core/scene/levels_worker.h"

#include <GL/glew.h>

namespace texplorer::screenshot {
namespace {

Result<Picture> drawScene(const Drawing& drawing) {
    // The scene is drawn into a framebuffer object: the context's own one is never seen.
    const Result<offscreen::OsmesaContext> context = offscreen::OsmesaContext::create({1, 1});
    if (!context)
        return fail(context.error());
    const Result<render::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    Result<render::SceneRenderer> renderer =
        render::createRenderer(drawing.renderer, *capabilities, {drawing.shaders, {}});
    if (!renderer)
        return fail(renderer.error());
    LevelsWorker levels(LevelsWorker::When::AtOnce, {}, drawing.levels);
    Result<render::Frame> frame =
        renderer->draw(drawing.scene, drawing.images, drawing.time, drawing.size, &levels);
    if (!frame)
        return fail(frame.error());
    Result<Image> image = renderer->read();
    if (!image)
        return fail(image.error());
    return Picture{std::move(*image), std::move(frame->problems), render::driverFacts(*capabilities)};
}

constexpr int settlingFrames = 3; // until Dear ImGui has given every window its size

Result<Picture> drawWindow(const Drawing& drawing) {
    const Result<offscreen::OsmesaContext> context = offscreen::OsmesaContext::create(drawing.size);
    if (!context)
        return fail(context.error());
    Result<stage::Stage> stage = stage::Stage::create(1, {drawing.shaders, {}});
    if (!stage)
        return fail(stage.error());

    ui::Session session = ui::makeSession(drawing.scene, drawing.images, drawing.file);
    session.levelsAtOnce =
        std::make_shared<LevelsWorker>(LevelsWorker::When::AtOnce, std::function<void()>(), drawing.levels);
    session.referenceAtOnce = std::make_shared<reference::DrawWorker>(
        reference::DrawWorker::When::AtOnce, std::function<void()>(), drawing.levels);
    showOne(session.views, drawing.renderer);
    session.playback.time = drawing.time;
    session.showsFrameTime = false;
    session.wantedTab = drawing.tab;
    for (int frame = 0; frame < settlingFrames; ++frame)
        stage->draw(session, {drawing.size, drawing.size, 1});

    Image image = Image::uninitialised(PixelFormat::Rgba8, drawing.size.width, drawing.size.height);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    return Picture{std::move(image), stage->problems(), render::driverFacts(stage->capabilities())};
}

} // namespace
} // namespace texplorer::screenshot

extern "C" [[gnu::visibility("default")]] void
texshotDraw(const texplorer::screenshot::Drawing& drawing,
            texplorer::Result<texplorer::screenshot::Picture>& picture) {
    using namespace texplorer::screenshot;
    picture = drawing.window ? drawWindow(drawing) : drawScene(drawing);
}
