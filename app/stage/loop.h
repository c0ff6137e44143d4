#pragma once

#include "app/stage/event.h"
#include "app/stage/input_queue.h"
#include "app/stage/stage.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::stage {

/// What a host is to do after a step.
struct Step {
    /// When to call again if nothing happens before, in seconds on the clock of `now`. What is not later than
    /// `now`: as soon as the display can take another picture. Nothing: when something happens.
    std::optional<double> wake;
    bool drawn = false;      ///< there is a new picture in the framebuffer
    bool unfinished = false; ///< the next frame differs, without anything that happens
    bool quit = false;       ///< the user has closed the window, and decided about unsaved changes
    std::string title{};     ///< of the window; only where it was drawn
    ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow; ///< what the pointer should look like; likewise
};

/// The text that one program leaves for another. Without functions the window keeps its own.
struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const std::string& text)> write;
};

/// The whole program but for its host: a host waits for events and for the time, calls `step`, and shows what
/// was drawn. Whether it is GLFW, OSMesa or a test makes no difference here. All on the thread of the
/// graphics.
class Loop {
public:
    /// `graphics` and `session` must outlive it.
    Loop(Graphics& graphics, ui::Session& session, const Surface& surface, Clipboard clipboard = {});
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;
    ~Loop();

    /// What has happened since the last call, in that order, and one frame. `now` is in seconds on a clock
    /// that only goes forwards. Nothing is drawn while nobody sees it.
    [[nodiscard]] Step step(double now, const std::vector<Event>& events);

    /// What the renderers said of the last frame's scene.
    [[nodiscard]] const std::vector<std::string>& problems() const { return stage_.problems(); }

private:
    void receive(const Event& event);
    [[nodiscard]] std::optional<double> nextWake(double now) const;

    ui::Session& session_;
    Surface surface_;
    Stage stage_;
    Clipboard clipboard_;
    std::string pasted_; ///< what Dear ImGui was given last
    InputQueue input_;
    int settling_;               ///< frames that are still to be drawn until everything has its place
    std::optional<double> last_; ///< when the last step was
};

} // namespace texplorer::stage
