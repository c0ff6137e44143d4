#pragma once

#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/widgets/inset_placement.h"
#include "texplorer/base/sentence.h"
#include "texplorer/reference/explain/explanation.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {

/// A small picture of a part of a level, at an edge of the canvas.
struct Inset {
    const reference::LevelPatch* patch;
    ImVec2 low; ///< upper left, of the texels
    float cell; ///< the extent of a texel
    Sentence title;
    std::string shown; ///< the part that fits, in the window's language
    float width;       ///< of the frame; the title may make it wider than the texels

    [[nodiscard]] ImVec2 size() const {
        return {cell * static_cast<float>(patch->size.x), cell * static_cast<float>(patch->size.y)};
    }
    /// Converts texels to window positions; row 0 is the lowest.
    [[nodiscard]] ImVec2 toWindow(glm::vec2 texel) const {
        return {low.x + (texel.x - static_cast<float>(patch->low.x)) * cell,
                low.y + size().y - (texel.y - static_cast<float>(patch->low.y)) * cell};
    }
    /// The box of a texel.
    [[nodiscard]] Box boxOf(glm::ivec2 texel) const {
        return {toWindow(texel + glm::ivec2(0, 1)), toWindow(texel + glm::ivec2(1, 0))};
    }
    /// Including its title.
    [[nodiscard]] Box frame() const;
    [[nodiscard]] bool holds(ImVec2 at) const {
        return at.x >= low.x && at.y >= low.y && at.x < low.x + size().x && at.y < low.y + size().y;
    }
};

/// The height of the title above an inset.
[[nodiscard]] float insetTitleHeight();

/// The patch of the level with the greatest share.
[[nodiscard]] const reference::LevelPatch& heaviestPatch(const reference::UnitExplanation& unit);

/// The position of the sample, in the plane of the image.
[[nodiscard]] ImVec2 sampleIn(const Canvas& canvas, const reference::UnitExplanation& unit);

/// A texel of a level, in the plane of the image.
[[nodiscard]] Box texelBox(const Canvas& canvas, glm::ivec2 at, glm::ivec2 extent);

/// Of a footprint, one after the other.
using Corners = std::array<ImVec2, 4>;

/// The parallelogram that a pixel covers around a position; the second one in the plane of the image.
[[nodiscard]] Corners footprintOf(ImVec2 middle, ImVec2 dx, ImVec2 dy);
[[nodiscard]] Corners footprintIn(const Canvas& canvas, const reference::UnitExplanation& unit);
[[nodiscard]] bool isFinite(const Corners& corners);

/// The box around the texels, the footprint and the position of the sample.
[[nodiscard]] Box marksOf(const reference::UnitExplanation& unit, const Canvas& canvas);

/// As large as possible without hiding what they explain. None: nothing is explained, or there is no room.
[[nodiscard]] std::vector<Inset> insetsOf(const reference::UnitExplanation* unit, const Canvas& canvas);

/// Draws what the selected unit reads at the probed pixel: the pixel's footprint, the position of the sample,
/// the texels and, in small pictures at the lower edge, their neighbourhood on each level, with their
/// weights. A click on a texel selects it, unless `clicked` on a vertex. `board`: transparent parts show a
/// checkerboard. `insets`: those of the probed pixel.
void drawTexelMarks(const Session& session, ImDrawList& draw, const Canvas& canvas,
                    std::span<const Inset> insets, bool clicked, bool board);

} // namespace texplorer::ui
