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

#include "texplorer/scene/scene.h"

#include <compare>
#include <cstddef>
#include <vector>

namespace texplorer {

/// Which picture of passes a texture shows.
struct PictureKey {
    int number = 1; ///< Pass::picture
    int size = 0;   ///< texels per side

    auto operator<=>(const PictureKey&) const = default;
};
[[nodiscard]] inline PictureKey pictureOf(const Texture& texture) {
    return {texture.picture, texture.pictureSize};
}

/// The seconds between two frames.
inline constexpr double frameInterval = 1.0 / 30;

/// The scene with the passes of one picture, or of the window (0), as those that are drawn: the others are
/// off.
[[nodiscard]] Scene picturedScene(const Scene& scene, int picture);

/// Whether a pass draws in a picture.
[[nodiscard]] bool hasPictures(const Scene& scene);

/// The pictures that enabled units show, in the order in which they are drawn, each once.
[[nodiscard]] std::vector<PictureKey> shownPictures(const Scene& scene);

/// Whether what a pass draws is seen: in the window, or in a picture that an enabled unit shows.
[[nodiscard]] bool isSeen(const Scene& scene, const Pass& pass);

/// A pass that shows a picture which is not finished when it draws.
struct UnfinishedRead {
    std::size_t pass = 0;
    std::size_t texture = 0;
};
[[nodiscard]] std::vector<UnfinishedRead> unfinishedReads(const Scene& scene);

/// The number of frames that the shown textures need: at least 1.
[[nodiscard]] int shownFrames(const Scene& scene);

} // namespace texplorer
