#pragma once

#include "app/stage/graphics.h"
#include "app/stage/surface.h"
#include "app/ui/window/workbench.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::stage {

/// Draws whole frames, the scene first and then the panels, for its Loop. Owns the Dear ImGui context: one
/// per process, on the thread of the graphics.
class Stage {
public:
    /// `graphics` must outlive the stage. `scale` is the monitor's content scale.
    Stage(Graphics& graphics, float scale);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    Stage(Stage&&) noexcept;
    Stage& operator=(Stage&&) noexcept;
    ~Stage();

    /// Draws a frame, `seconds` after the last one; the scale may change between frames. `feedInput` is
    /// called right before ImGui::NewFrame, after the display size was set.
    ui::Requests draw(ui::Session& session, const Surface& surface, float seconds,
                      const std::function<void()>& feedInput = {});

    /// The renderers' problems with the scene in the last frame.
    [[nodiscard]] const std::vector<Sentence>& problems() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::stage
