#pragma once

#include "app/view/offered_renderers.h"
#include "core/reference/false_colors.h"
#include "core/reference/sampling/lod.h"
#include "core/scene/renderer.h"

#include <glm/vec2.hpp>

#include <array>
#include <string>
#include <vector>

namespace texplorer::ui {

/// How the pictures of the renderers lie in the view.
enum class Arrangement {
    One,   ///< one picture
    Split, ///< two in the place of one, with a seam between them that one drags
    Grid,  ///< every renderer's and the difference of the compared ones, side by side
    Kept,  ///< one renderer's of what was kept as A and of what is now, with a seam: see kept.h
};

/// What is shown of the pictures, the same part of all of them.
struct PictureZoom {
    int factor = 1;         ///< pixels of the screen for one of the picture
    glm::vec2 centre{0.5F}; ///< of the part that is shown, as a share of the picture, from its lower left
    static constexpr int largest = 32;

    bool operator==(const PictureZoom&) const = default;
};

/// Which pictures are shown. Belongs to the window, but for what a lesson's step has chosen: see
/// lesson_run.h.
struct ShownPictures {
    Arrangement arrangement = Arrangement::One;
    RendererKind renderer = RendererKind::Fixed; ///< of the one picture
    std::array<RendererKind, 2> compared{RendererKind::Fixed, RendererKind::Reference};
    Arrangement comparing = Arrangement::Split; ///< what Compare leads to: Split or Grid, as it was last
    reference::Shown shown = reference::Shown::Picture; ///< false colours lie over the pictures, or none

    bool operator==(const ShownPictures&) const = default;
};

/// What of the pictures is shown. Belongs to the document.
struct ShownPart {
    PictureZoom zoom;
    bool stepsThroughPasses = false; ///< those after the chosen one are left out
};

/// Which renderers draw the scene, and how one looks at what they drew.
struct ViewSettings : ShownPictures, ShownPart {
    reference::AnisotropyMethod anisotropy = reference::AnisotropyMethod::Probes; ///< of the reference
    reference::RhoMethod rho = reference::RhoMethod::Ideal;                       ///< likewise
    float split = 0.5F;     ///< where the seam is, as a share of the picture's width
    int tolerance = 2;      ///< differences up to here don't count, in 255ths
    bool magnifies = false; ///< the pixels under the mouse are shown enlarged
    int stripLines = 0; ///< of what is said below compared pictures, as measured with the last frame; 0: none
    float opacity = 0.85F;          ///< of the false colours
    view::OfferedRenderers offered; ///< by the host: of the others nothing is shown

    static constexpr int largestTolerance = 254;
};

[[nodiscard]] inline bool isComparing(const ViewSettings& settings) {
    return settings.arrangement != Arrangement::One;
}

/// Whether it is renderers that are compared.
[[nodiscard]] inline bool comparesRenderers(const ViewSettings& settings) {
    return isComparing(settings) && settings.arrangement != Arrangement::Kept;
}

/// Whether the panels need the pixels of the pictures, not only something to show.
[[nodiscard]] inline bool wantsPixels(const ViewSettings& settings) {
    return isComparing(settings) || settings.magnifies;
}

/// Those whose pictures are shown, in the order of their panes; the one that draws both sides once.
[[nodiscard]] std::vector<RendererKind> shownRenderers(const ViewSettings& settings);

/// Whether there are two to compare.
[[nodiscard]] bool canCompare(const ViewSettings& settings);

/// Shows one renderer's picture, of what is now or of both sides. Nothing happens where it isn't offered.
void showOne(ViewSettings& settings, RendererKind renderer);

/// As a window begins: one picture, of the best renderer, without false colours.
void showAsAtFirst(ViewSettings& settings);

/// Compares, in the arrangement that was used last. Nothing happens where there aren't two.
void showComparison(ViewSettings& settings);

/// Compares exactly these, of which there must be two or more: two with a seam, more side by side. All must
/// be offered.
void showComparison(ViewSettings& settings, const std::vector<RendererKind>& renderers);

/// From here on the host has these. Who isn't there gives way to who is; where that changes what is shown, a
/// sentence says it.
[[nodiscard]] std::string offerRenderers(ViewSettings& settings, const view::OfferedRenderers& offered);

} // namespace texplorer::ui
