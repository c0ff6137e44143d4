#include "app/explorer/loop.h"

#include "app/explorer/input.h"
#include "app/opengl/opengl_graphics.h"
#include "app/stage/stage.h"
#include "app/ui/model/asking.h"
#include "app/ui/model/loads.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/session.h"

#include <imgui.h>

#include <algorithm>
#include <cstdlib>

namespace texplorer::explorer {
namespace {

constexpr int settlingFrames = 3;    // Dear ImGui needs these after an input until everything has its place
constexpr double caretSeconds = 0.4; // how often a blinking text cursor is drawn
constexpr double longestStep = 0.1;  // seconds of animation in one frame, after the window was hidden or busy

Autosave* keptAtExit = nullptr;

/// While one of these lives, exit() writes what is not saved: Xlib calls it when the display goes away, which
/// is how many sessions end.
class KeptAtExit {
public:
    explicit KeptAtExit(Autosave& autosave) {
        static const int registered = std::atexit([] {
            if (keptAtExit)
                (void)keptAtExit->flush();
        });
        (void)registered;
        keptAtExit = &autosave;
    }
    KeptAtExit(const KeptAtExit&) = delete;
    KeptAtExit& operator=(const KeptAtExit&) = delete;
    ~KeptAtExit() { keptAtExit = nullptr; }
};

/// While one of these lives, a signal writes what is not saved, and wakes the window so that it ends.
class KeptOnSignal {
public:
    KeptOnSignal(Signals& signals, Autosave& autosave)
        : signals_(signals) {
        signals_.onRequest([&autosave] {
            (void)autosave.flush();
            Window::wake();
        });
    }
    KeptOnSignal(const KeptOnSignal&) = delete;
    KeptOnSignal& operator=(const KeptOnSignal&) = delete;
    ~KeptOnSignal() { signals_.onRequest({}); }

private:
    Signals& signals_;
};

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

Result<void> runLoop(Window& window, Signals& signals, const std::vector<std::filesystem::path>& files,
                     const std::filesystem::path& shaders) {
    const auto graphics = opengl::OpenGlGraphics::create({shaders, Window::wake});
    if (!graphics)
        return fail(graphics.error());
    stage::Stage stage(**graphics, window.contentScale());
    const Input input(window.handle());
    ui::ServicesBeside services(Window::wake, BlockCache::ofUser());
    ui::UnsavedWork unsaved(unsavedFolderOfUser(), Window::wake);
    ui::Session session(services.lend(&unsaved));
    const KeptAtExit atExit(unsaved.autosave);
    const KeptOnSignal onSignal(signals, unsaved.autosave);
    ui::report(session, ui::openArguments(session, files));

    int settling = settlingFrames;
    double last = window.now();
    for (;;) {
        const Window::Events events = window.takeEvents();
        if (signals.received() != 0) {
            (void)unsaved.autosave.flush(); // with what the last frame changed
            return {};
        }
        if (events.any)
            settling = settlingFrames;
        if (!events.dropped.empty())
            ui::requestOpen(session, events.dropped);
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
            stage.draw(session, {window.size(), window.framebuffer(), window.contentScale()}, feedInput);
        window.setTitle(requests.title);
        window.swap();
        if (requests.quit) {
            unsaved.autosave.forget(); // the user has decided
            (void)unsaved.autosave.flush();
            return {};
        }
        if (requests.fading || requests.unfinished)
            settling = settlingFrames;

        settling = std::max(0, settling - 1);
        pace(window, ui::isMoving(session), settling > 0, last);
    }
}

} // namespace texplorer::explorer
