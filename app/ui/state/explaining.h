#pragma once

#include "texplorer/image/image.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/reference/probe_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// The user's questions about the picture: why a pixel has its colour, and which pixels a texel contributes
/// to.
struct Explaining {
    std::optional<reference::PixelPlace> pixel{};
    std::optional<reference::TexelQuestion> texel{};
    std::shared_ptr<const TextureImage> texelOf{}; ///< the image of the texel: cleared together with it
    std::shared_ptr<const reference::ProbeWorker::Answer>
        answer{};                         ///< the newest answer; may be for an earlier question
    std::shared_ptr<const Image> light{}; ///< from the answer: alpha is the texel's weight in each pixel
    std::shared_ptr<const reference::ProbeWorker::Answer> lightOf{};
    /// The answer for a pinned pixel, shown next to the current one, as it was when it was pinned; nullptr:
    /// none.
    std::shared_ptr<const reference::ProbeWorker::Answer> pinned{};
    bool isOpen = false; ///< the tab is in front: a click in the view selects the pixel
};

} // namespace texplorer::ui
