#pragma once

// Pictures of passes, for textures that show them (SourceKind::Picture).
//
// A pass draws in the window or in a picture (Pass::picture). A picture is square, is cleared to the scene's
// background before its first pass, and has the view of the scene. In a frame, the pictures are drawn in the
// order of the textures that show them, each by its passes in their order; then the window. So a pass that
// shows a picture which is not finished, its own or one of a later texture, shows that of the frame before.
// Therefore as many frames are drawn as the texture with the most of them says (Texture::frames), 1/30 s
// apart; the last one is at the time of the picture, and none is before 0 s. What the first frame shows of
// pictures that are not drawn is black, with alpha 0.

#include "texplorer/base/result.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace texplorer::reference {

/// The seconds between two frames.
inline constexpr double frameInterval = 1.0 / 30;

/// The scene with the passes of one picture, or of the window (0), as those that are drawn: the others are
/// off.
[[nodiscard]] Scene picturedScene(const Scene& scene, int picture);

/// Whether a pass draws in a picture.
[[nodiscard]] bool hasPictures(const Scene& scene);

/// The pictures that enabled units show, in the order in which they are drawn, each once.
[[nodiscard]] std::vector<PictureKey> shownPictures(const Scene& scene);

/// A pass that shows a picture which is not finished when it draws.
struct UnfinishedRead {
    std::size_t pass = 0;
    std::size_t texture = 0;
};
[[nodiscard]] std::vector<UnfinishedRead> unfinishedReads(const Scene& scene);

/// The number of frames that the shown textures need: at least 1.
[[nodiscard]] int shownFrames(const Scene& scene);

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
