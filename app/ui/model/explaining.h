#pragma once

#include "app/view/size.h"
#include "core/reference/probe_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

struct Session;

/// What the user asks about the picture: why a pixel has its colour, and which pixels a texel has a share in.
struct Explaining {
    std::optional<reference::PixelPlace> pixel{};
    std::optional<reference::TexelQuestion> texel{};
    std::shared_ptr<const TextureImage> texelOf{}; ///< the image that it was picked in: it goes with it
    std::shared_ptr<const reference::ProbeWorker::Answer> answer{}; ///< the newest; may be an earlier one's
    std::shared_ptr<const Image> light{}; ///< of the answer: the texel's weight in each pixel as alpha
    std::shared_ptr<const reference::ProbeWorker::Answer> lightOf{};
    /// A pixel that stays beside the one that is explained, as it was when it was pinned; nullptr: none.
    std::shared_ptr<const reference::ProbeWorker::Answer> pinned{};
    bool isOpen = false; ///< the tab is in front: then a click in the view chooses the pixel
};

/// To be called once a frame, before the panels: asks what the session wants to know of the picture, which
/// has this size in pixels, and takes what there is to know by now. A pixel outside of a picture that became
/// smaller is forgotten.
void askAboutPicture(Session& session, view::Size picture);

/// What the selected unit of the selected pass did at the pixel, in the fragment that one sees; nullptr:
/// nothing, or nothing is known.
[[nodiscard]] const reference::UnitExplanation* probedUnit(const Session& session);

/// The explanation that there is; nullptr: none.
[[nodiscard]] const reference::Explanation* explanationOf(const Session& session);

/// Of the pinned pixel; nullptr: none is pinned.
[[nodiscard]] const reference::Explanation* pinnedExplanation(const Session& session);

/// Keeps what there is to know of the pixel, for a comparison. Nothing happens where there is no explanation.
void pinPixel(Session& session);

/// Whether it is about the scene, the pixel and the time as they are now, and not about earlier ones.
[[nodiscard]] bool explainsThePicture(const Session& session);

/// Asks for a texel of the selected unit; asks no longer where it was the one.
void chooseTexel(Session& session, const reference::TexelPlace& texel);
void clearTexel(Session& session);

} // namespace texplorer::ui
