#pragma once

#include "app/view/offered_renderers.h"
#include "texplorer/base/sentence.h"
#include "texplorer/reference/false_colors.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/renderer.h"

#include <glm/vec2.hpp>

#include <array>
#include <vector>

namespace texplorer::ui {

/// The arrangement of the renderers' pictures in the view.
enum class Arrangement {
    One,   ///< one picture
    Split, ///< two in one place, with a seam that can be dragged
    Grid,  ///< the pictures of all renderers and the difference of the compared ones, in a grid
    Kept,  ///< one renderer's pictures of the kept state A and of the current scene, with a seam: see kept.h
};

/// The visible part of the pictures, the same for all of them.
struct PictureZoom {
    int factor = 1;         ///< screen pixels per pixel of the picture
    glm::vec2 centre{0.5F}; ///< of the visible part, as a fraction of the picture, from its lower left
    static constexpr int maxFactor = 32;

    bool operator==(const PictureZoom&) const = default;
};

/// Which pictures are shown. Belongs to the window, except for the choice of a lesson's step: see
/// lesson_run.h.
struct ShownPictures {
    Arrangement arrangement = Arrangement::One;
    RendererKind renderer = RendererKind::Fixed; ///< for one picture
    std::array<RendererKind, 2> compared{RendererKind::Fixed, RendererKind::Reference};
    Arrangement comparing = Arrangement::Split;         ///< the last arrangement for Compare: Split or Grid
    reference::Shown shown = reference::Shown::Picture; ///< false colours over the pictures, or none

    bool operator==(const ShownPictures&) const = default;
};

/// The shown part of the pictures. Belongs to the document.
struct ShownPart {
    PictureZoom zoom;
    bool stepsThroughPasses = false; ///< passes after the selected one are left out
};

/// Which renderers draw the scene, and how their pictures are shown.
struct ViewSettings : ShownPictures, ShownPart {
    reference::AnisotropyMethod anisotropy = reference::AnisotropyMethod::Probes; ///< for the reference
    reference::RhoMethod rho = reference::RhoMethod::Ideal;                       ///< for the reference
    float split = 0.5F;     ///< the seam's position, as a fraction of the picture's width
    int tolerance = 2;      ///< differences up to this value are ignored, in 255ths
    bool magnifies = false; ///< the pixels under the mouse are magnified
    int stripLines = 0;     ///< lines of text below compared pictures, measured in the last frame; 0: none
    float opacity = 0.85F;  ///< of the false colours
    view::OfferedRenderers offered; ///< by the host: others are not shown

    static constexpr int maxTolerance = 254;
};

[[nodiscard]] inline bool isComparing(const ViewSettings& settings) {
    return settings.arrangement != Arrangement::One;
}

/// Whether two renderers are compared.
[[nodiscard]] inline bool comparesRenderers(const ViewSettings& settings) {
    return isComparing(settings) && settings.arrangement != Arrangement::Kept;
}

/// Whether the panels need the pixels, not only pictures to show.
[[nodiscard]] inline bool wantsPixels(const ViewSettings& settings) {
    return isComparing(settings) || settings.magnifies;
}

/// The renderers of the shown pictures, in the order of their panes; one that draws both sides occurs once.
[[nodiscard]] std::vector<RendererKind> shownRenderers(const ViewSettings& settings);

/// Whether there are two renderers to compare.
[[nodiscard]] bool canCompare(const ViewSettings& settings);

/// Shows the picture of one renderer, of the current scene or of both sides. Does nothing if it is not
/// offered.
void showOne(ViewSettings& settings, RendererKind renderer);

/// The initial state of a window: one picture, by the best renderer, without false colours.
void showAsAtFirst(ViewSettings& settings);

/// Shows a comparison in the last arrangement. Does nothing with fewer than two renderers.
void showComparison(ViewSettings& settings);

/// Compares exactly these renderers, two or more: two with a seam, more in a grid. All must be offered.
void showComparison(ViewSettings& settings, const std::vector<RendererKind>& renderers);

/// Sets the renderers of the host. Shown renderers that are missing are replaced; returns a sentence if the
/// picture changes.
[[nodiscard]] Sentence offerRenderers(ViewSettings& settings, const view::OfferedRenderers& offered);

} // namespace texplorer::ui
