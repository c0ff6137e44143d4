#pragma once

// Pictures of passes, as the reference or OpenGL draws them: see texplorer/scene/pass_pictures.h.

#include "texplorer/base/result.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/pass_pictures.h"
#include "texplorer/texture/image_source.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace texplorer::reference {

/// Draws a scene without key frames at a time: `size` pixels per side, Rgba8, bottom row first.
using DrawPicture =
    std::function<Result<Image>(const Scene& scene, const ImageSource& images, double time, int size)>;

/// The pictures of a scene, cached until what they depend on changes.
class DrawnPictures {
public:
    /// Returns `images` with the pictures that the scene's textures show and that are missing. `revision`
    /// changes when anything else changes that `draw` depends on. Errors: those of `draw`.
    [[nodiscard]] Result<ImageSource> addedTo(const ImageSource& images, const Scene& scene, double time,
                                              const DrawPicture& draw, std::uint64_t revision = 0);

private:
    struct Seen {
        Scene scene;
        ImageSource images;
        double time = 0;
        std::uint64_t revision = 0;

        bool operator==(const Seen&) const = default;
    };

    std::optional<Seen> seen_;
    ImageSource drawn_; ///< the last result; its pictures keep their address while they stay the same
};

} // namespace texplorer::reference
