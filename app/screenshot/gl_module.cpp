// The GL half of texshot: OSMesa, the renderer and, for --ui, the panels.

#include "app/screenshot/gl_module.h"

#include "app/offscreen/osmesa_context.h"
#include "app/render/capabilities.h"
#include "app/render/fixed_renderer.h"

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
    Result<render::FixedRenderer> renderer = render::FixedRenderer::create(*capabilities);
    if (!renderer)
        return fail(renderer.error());
    Result<render::Frame> frame = renderer->draw(drawing.scene, drawing.images, drawing.time, drawing.size);
    if (!frame)
        return fail(frame.error());
    Result<Image> image = renderer->read();
    if (!image)
        return fail(image.error());
    return Picture{std::move(*image), std::move(frame->problems)};
}

} // namespace
} // namespace texplorer::screenshot

extern "C" [[gnu::visibility("default")]] void
texshotDraw(const texplorer::screenshot::Drawing& drawing,
            texplorer::Result<texplorer::screenshot::Picture>& picture) {
    picture = texplorer::screenshot::drawScene(drawing);
}
