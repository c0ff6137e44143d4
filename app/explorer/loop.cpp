#include "app/explorer/loop.h"

#include "app/explorer/input.h"
#include "app/stage/stage.h"
#include "app/ui/document.h"

#include <imgui.h>

#include <algorithm>

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

} // namespace

Result<void> runLoop(Window& window, ui::Session& session, const std::vector<std::filesystem::path>& files,
                     const std::filesystem::path& shaders) {
    Result<stage::Stage> stage = stage::Stage::create(window.contentScale(), {shaders, Window::wake});
    if (!stage)
        return fail(stage.error());
    const Input input(window.handle());
    ui::Background background(Window::wake, BlockCache::ofUser());
    session.background = &background;
    ui::report(session, ui::openArguments(session, files));

    int settling = settlingFrames;
    double last = window.now();
    for (;;) {
        const Window::Events events = window.takeEvents();
        if (events.any)
            settling = settlingFrames;
        for (const std::filesystem::path& path : events.dropped)
            ui::requestOpen(session, path);
        if (events.close)
            ui::requestQuit(session);
        if (window.isHidden() && !events.close) {
            window.wait();
            last = window.now();
            continue;
        }

        if (ui::receiveFiles(session))
            settling = settlingFrames;
        const double now = window.now();
        ui::advance(session, std::min(now - last, longestStep));
        last = now;

        const auto feedInput = [&] {
            if (window.feedKeys())
                settling = settlingFrames;
            Input::feed();
        };
        const ui::Requests requests =
            stage->draw(session, {window.size(), window.framebuffer(), window.contentScale()}, feedInput);
        window.setTitle(requests.title);
        window.swap();
        if (requests.quit)
            return {};
        if (requests.fading || requests.unfinished)
            settling = settlingFrames;

        settling = std::max(0, settling - 1);
        pace(window, ui::isMoving(session), settling > 0, last);
    }
}

} // namespace texplorer::explorer
