#include "texplorer/reference/draw_request.h"

#include "texplorer/texture/texture_levels.h"

#include <algorithm>

namespace texplorer::reference {

bool sameLevels(const DrawRequest& a, const DrawRequest& b) {
    return std::ranges::equal(a.scene.textures, b.scene.textures,
                              [&](const Texture& one, const Texture& other) {
                                  return imageSettings(one) == imageSettings(other) &&
                                         a.images.picturesOf(one) == b.images.picturesOf(other);
                              });
}

} // namespace texplorer::reference
