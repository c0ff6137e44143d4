#pragma once

#include "app/stage/graphics.h"
#include "app/ui/window/workbench.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::stage {

/// Where a frame goes: the framebuffer that is bound when Stage::draw is called.
struct Surface {
    view::Size size;   ///< in the units of the mouse, which on some systems are larger than pixels
    view::Size pixels; ///< of the framebuffer
    float scale = 1;   ///< of the monitor's content: how large text should be, in pixels
};

/// Draws whole frames, the scene first and the panels around it. Both programs are a Stage and a host that
/// lends it its graphics. Owns the Dear ImGui context; one a process, on the thread of the graphics.
class Stage {
public:
    /// `graphics` must outlive the stage. `scale` is that of the monitor's content.
    Stage(Graphics& graphics, float scale);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    Stage(Stage&&) noexcept;
    Stage& operator=(Stage&&) noexcept;
    ~Stage();

    /// One frame; between two frames the scale may change. `feedInput` is called right before
    /// ImGui::NewFrame, with the display size already set: a window's backend, or synthetic events.
    ui::Requests draw(ui::Session& session, const Surface& surface,
                      const std::function<void()>& feedInput = {});

    /// What the renderers said of the last frame's scene.
    [[nodiscard]] const std::vector<std::string>& problems() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::stage
