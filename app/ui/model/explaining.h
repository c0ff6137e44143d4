#pragma once

#include "core/reference/probe_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// What the user asks about the picture: why a pixel has its colour, and which pixels a texel has a share in.
struct Explaining {
    std::optional<reference::PixelPlace> pixel{};
    std::optional<reference::TexelQuestion> texel{};
    std::shared_ptr<const TextureImage> texelOf{}; ///< the image that it was picked in: it goes with it
    std::shared_ptr<const reference::ProbeWorker::Answer> answer{}; ///< the newest; may be an earlier one's
    std::shared_ptr<const Image> light{}; ///< of the answer: the texel's weight in each pixel, to lay over it
    std::shared_ptr<const reference::ProbeWorker::Answer> lightOf{};
    bool isOpen = false; ///< the tab is in front: then a click in the view chooses the pixel
};

} // namespace texplorer::ui
