#pragma once

#include "app/stage/graphics.h"
#include "app/stage/surface.h"
#include "app/ui/window/workbench.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::stage {

/// Draws whole frames, the scene first and the panels around it, when its Loop says so. Owns the Dear ImGui
/// context; one a process, on the thread of the graphics.
class Stage {
public:
    /// `graphics` must outlive the stage. `scale` is that of the monitor's content.
    Stage(Graphics& graphics, float scale);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    Stage(Stage&&) noexcept;
    Stage& operator=(Stage&&) noexcept;
    ~Stage();

    /// One frame, `seconds` after the last one; between two frames the scale may change. `feedInput` is
    /// called right before ImGui::NewFrame, with the display size already set.
    ui::Requests draw(ui::Session& session, const Surface& surface, float seconds,
                      const std::function<void()>& feedInput = {});

    /// What the renderers said of the last frame's scene.
    [[nodiscard]] const std::vector<std::string>& problems() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::stage
