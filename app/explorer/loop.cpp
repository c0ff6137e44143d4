#include "app/explorer/loop.h"

#include "app/explorer/panel_host.h"
#include "app/render/capabilities.h"
#include "app/render/fixed_renderer.h"
#include "app/render/texture_preview.h"
#include "app/ui/workbench.h"

#include <GL/glew.h>

#include <algorithm>
#include <cmath>

namespace texplorer::explorer {
namespace {

constexpr int settlingFrames = 3;    // Dear ImGui needs these after an input until everything has its place
constexpr double caretSeconds = 0.4; // how often a blinking text cursor is drawn
constexpr double longestStep = 0.1;  // seconds of animation in one frame, after the window was hidden or busy

/// Sleeps until it is time for the next frame.
void pace(Window& window, bool moving, bool settling, double lastFrame) {
    if (!moving && !settling) {
        if (ImGui::GetIO().WantTextInput)
            window.wait(caretSeconds);
        else
            window.wait();
    }
    // Where the driver doesn't wait for the monitor, or the mouse reports a thousand times a second.
    const double due = lastFrame + window.frameSeconds() * 0.95;
    do
        window.wait(due - window.now());
    while (window.now() < due);
}

void setBlending(const ImDrawList* /*list*/, const ImDrawCmd* command) {
    (command->UserCallbackData ? glEnable : glDisable)(GL_BLEND);
}

} // namespace

Result<void> runLoop(Window& window, ui::Session& session) {
    const Result<render::Capabilities> capabilities = render::loadCapabilities();
    if (!capabilities)
        return fail(capabilities.error());
    Result<render::FixedRenderer> renderer = render::FixedRenderer::create(*capabilities);
    if (!renderer)
        return fail(renderer.error());
    render::TexturePreview preview;
    float scale = window.contentScale();
    PanelHost panels(window.handle(), scale);

    int settling = settlingFrames;
    double last = window.now();
    for (;;) {
        const Window::Events events = window.takeEvents();
        if (events.any)
            settling = settlingFrames;
        if (events.scaleChanged) {
            scale = window.contentScale();
            panels.setScale(scale);
        }
        for (const std::filesystem::path& path : events.dropped)
            ui::requestOpen(session, path);
        if (events.close)
            ui::requestQuit(session);
        if (window.isHidden() && !events.close) {
            window.wait();
            last = window.now();
            continue;
        }

        const double now = window.now();
        ui::advance(session, std::min(now - last, longestStep));
        last = now;

        // The panels are laid out in the coordinates of the mouse, which on some systems are larger than
        // pixels.
        const render::Size size = window.size();
        const render::Size pixels = window.framebuffer();
        const float density = static_cast<float>(pixels.width) / static_cast<float>(std::max(1, size.width));
        const ui::Layout layout = ui::layoutFor(size.width, size.height, scale / density, session.columns);
        ui::settle(session, layout);
        const auto toPixels = [density](int length) {
            return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * density)));
        };
        const render::Size picture{toPixels(layout.picture.width), toPixels(layout.picture.height)};
        Result<render::Frame> drawn =
            renderer->draw(session.scene, session.images, session.playback.time, picture);
        const render::Frame frame =
            drawn ? std::move(*drawn) : render::Frame{0, picture, 0, {describe(drawn.error())}};
        const Texture* bound = ui::boundTexture(std::as_const(session));
        const unsigned texture = bound ? preview.show(*bound, session.images) : 0;

        panels.beginFrame();
        const ui::Requests requests =
            ui::drawWorkbench(session, {frame, texture, setBlending}, *capabilities, layout);
        panels.endFrame(pixels.width, pixels.height);
        window.setTitle(requests.title);
        window.swap();
        if (requests.quit)
            return {};

        settling = std::max(0, settling - 1);
        pace(window, ui::isMoving(session), settling > 0, last);
    }
}

} // namespace texplorer::explorer
