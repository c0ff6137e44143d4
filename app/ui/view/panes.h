#pragma once

#include "app/ui/state/view_settings.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/pictures.h"
#include "app/ui/widgets/points.h"
#include "app/view/frame.h"
#include "app/view/side.h"

#include <glm/vec2.hpp>
#include <imgui.h>

#include <optional>
#include <vector>

namespace texplorer::ui {

/// A place where a picture is shown.
struct Pane {
    std::optional<RendererKind> renderer; ///< its renderer; none: the difference of the compared ones
    Rect frame;                           ///< the picture, or its zoomed part
    Rect visible;                         ///< the visible part of the frame: a seam cuts it in two
    view::Side side = view::Side::Now;
};

/// Maps pixels of the pictures to the window. All pictures have the same size, and every pane shows the same
/// part of them. Window positions are Dear ImGui's, from the top left. Positions in a picture are GL's window
/// coordinates, as in glReadPixels and Image::at: from the lower left, the middle of the first pixel at 0.5,
/// 0.5.
class Panes {
public:
    Panes(const Layout& layout, const ViewSettings& settings, view::Size picture);

    [[nodiscard]] const std::vector<Pane>& all() const { return panes_; }
    [[nodiscard]] const Pane* under(ImVec2 place) const; ///< nullptr: none

    [[nodiscard]] glm::vec2 toPicture(const Pane& pane, ImVec2 place) const;
    [[nodiscard]] ImVec2 toWindow(const Pane& pane, glm::vec2 at) const;

    // The same for fractions of the picture from its upper left, as in projectVertex and pickVertex.
    [[nodiscard]] glm::vec2 shareAt(const Pane& pane, ImVec2 place) const;
    [[nodiscard]] ImVec2 shareToWindow(const Pane& pane, glm::vec2 share) const;

    /// The pixel at a position; none: there is no pane, or it has no picture.
    [[nodiscard]] std::optional<glm::ivec2> pixelAt(ImVec2 place) const;

    /// The size of a picture's pixel in the window.
    [[nodiscard]] glm::vec2 pixelExtent() const;

    /// The visible part of the pictures as fractions: lower left and upper right.
    [[nodiscard]] glm::vec2 partLow() const { return low_; }
    [[nodiscard]] glm::vec2 partHigh() const { return high_; }

    /// Draws the visible part of a picture into the pane's frame.
    void draw(ImDrawList& to, const Pane& pane, view::PictureHandle picture,
              ImU32 tint = IM_COL32_WHITE) const;

private:
    std::vector<Pane> panes_;
    glm::vec2 size_; // of the pictures
    glm::vec2 low_;
    glm::vec2 high_;
};

/// The grid of panes for these settings, which determines the size of the pictures.
[[nodiscard]] PaneGrid gridOf(const ViewSettings& settings);

/// Zooms by a power of two; the point of the picture under `place` stays there.
void zoomPictures(ViewSettings& settings, const Layout& layout, ImVec2 place, int notches);

/// Moves the visible part by an offset in the window.
void movePictures(ViewSettings& settings, const Layout& layout, ImVec2 way);

} // namespace texplorer::ui
