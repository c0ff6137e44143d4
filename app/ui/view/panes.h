#pragma once

#include "app/ui/model/layout.h"
#include "app/ui/model/view_settings.h"
#include "app/view/frame.h"
#include "app/view/side.h"

#include <glm/vec2.hpp>
#include <imgui.h>

#include <optional>
#include <vector>

namespace texplorer::ui {

/// A place where a picture is shown.
struct Pane {
    std::optional<RendererKind> renderer; ///< whose picture; none: the difference of the compared ones
    Rect frame;                           ///< where the picture is, or the part of it that the zoom shows
    Rect visible;                         ///< what one sees of the frame: a seam cuts it in two
    view::Side side = view::Side::Now;
};

/// Where the view shows which pixel of the pictures. All pictures have the same size, and every pane shows
/// the same part of them. Places in the window are Dear ImGui's: from the top left. Places in a picture are
/// GL's window coordinates, as of glReadPixels and Image::at: from the lower left, the middle of the first
/// pixel at 0.5, 0.5.
class Panes {
public:
    Panes(const Layout& layout, const ViewSettings& settings, view::Size picture);

    [[nodiscard]] const std::vector<Pane>& all() const { return panes_; }
    [[nodiscard]] const Pane* under(ImVec2 place) const; ///< nullptr: none

    [[nodiscard]] glm::vec2 toPicture(const Pane& pane, ImVec2 place) const;
    [[nodiscard]] ImVec2 toWindow(const Pane& pane, glm::vec2 at) const;

    /// The pixel that is shown there; none: no pane is there, or its picture is none.
    [[nodiscard]] std::optional<glm::ivec2> pixelAt(ImVec2 place) const;

    /// How large one pixel of a picture is in the window.
    [[nodiscard]] glm::vec2 pixelExtent() const;

    /// The part of the pictures that is shown, as shares of them: lower left and upper right.
    [[nodiscard]] glm::vec2 partLow() const { return low_; }
    [[nodiscard]] glm::vec2 partHigh() const { return high_; }

private:
    std::vector<Pane> panes_;
    glm::vec2 size_; // of the pictures
    glm::vec2 low_;
    glm::vec2 high_;
};

/// The grid that the panes of these settings make, which decides how large the pictures are.
[[nodiscard]] PaneGrid gridOf(const ViewSettings& settings);

/// Zooms by a power of two and keeps the place in the picture that lies under `place` where it is.
void zoomPictures(ViewSettings& settings, const Layout& layout, ImVec2 place, int notches);

/// Moves the part that is shown by a way in the window.
void movePictures(ViewSettings& settings, const Layout& layout, ImVec2 way);

} // namespace texplorer::ui
