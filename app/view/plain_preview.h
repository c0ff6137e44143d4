#pragma once

#include "app/view/preview_picture.h"
#include "texplorer/image/image.h"

#include <memory>
#include <optional>

namespace texplorer::view {

/// A PreviewPicture as an Rgba8 image, for hosts whose own textures have no other format.
class PlainPreview {
public:
    /// Bottom row first. It may be the previous one, or nullptr, until `levels` has the new one; nullptr if
    /// the image is not available or there is not enough memory.
    [[nodiscard]] std::shared_ptr<const Image> show(const Texture& texture, const ImageSource& images,
                                                    LevelsSource& levels);

private:
    PreviewPicture picture_;
    std::optional<LevelsRequest> previewed_; ///< what image_ was made of
    std::shared_ptr<const Image> image_;
};

} // namespace texplorer::view
