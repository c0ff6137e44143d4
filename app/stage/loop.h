#pragma once

#include "app/stage/event.h"
#include "app/stage/file_requests.h"
#include "app/stage/input_queue.h"
#include "app/stage/stage.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::stage {

/// The result of a step, for the host.
struct Step {
    /// When to call again if no event arrives, in seconds on the clock of `now`. Not later than `now`: as
    /// soon as the display can take another picture. Nothing: at the next event.
    std::optional<double> wake;
    bool drawn = false;      ///< the framebuffer has a new picture
    bool unfinished = false; ///< the next frame differs even without an event
    bool quit = false;       ///< the user has closed the window, and decided about unsaved changes
    std::string title{};     ///< of the window; only if a picture was drawn
    ImGuiMouseCursor cursor =
        ImGuiMouseCursor_Arrow; ///< the shape of the pointer; only if a picture was drawn
};

/// The clipboard of the system. Without functions the window keeps its own text.
struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const std::string& text)> write;
};

/// The whole program except its host. A host waits for events and for the time, calls `step`, and shows the
/// picture; it can be GLFW, OSMesa or a test. Call everything on the thread of the graphics.
class Loop {
public:
    /// `graphics` and `session` must outlive it.
    Loop(Graphics& graphics, ui::Session& session, const Surface& surface, Clipboard clipboard = {},
         FileRequests files = {});
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    ~Loop();

    /// Processes the events since the last call, in their order, and draws one frame. `now` is in seconds on
    /// a monotonic clock. Draws nothing while the window is not visible.
    [[nodiscard]] Step step(double now, const std::vector<Event>& events);

    /// The renderers' problems with the scene in the last frame.
    [[nodiscard]] const std::vector<Sentence>& problems() const { return stage_.problems(); }

private:
    void receive(const Event& event);
    [[nodiscard]] std::optional<double> nextWake(double now) const;

    ui::Session& session_;
    Surface surface_;
    Stage stage_;
    Clipboard clipboard_;
    FileRequests files_;
    std::string pasted_; ///< the text that Dear ImGui got last
    InputQueue input_;
    int settling_;               ///< frames to draw until the layout is final
    std::optional<double> last_; ///< the time of the last step
};

} // namespace texplorer::stage
