#pragma once

#include "app/ui/model/session.h"

#include <memory>
#include <string>

namespace texplorer::ui {

/// A summary of a texture's levels, with small pictures of its image; made in the background if that takes
/// long. nullptr: not ready.
[[nodiscard]] std::shared_ptr<const LevelsSummary> summaryOf(const Session& session, const Texture& texture,
                                                             Target target);

/// The largest level, small and upright; nullptr: not ready, or there is none.
[[nodiscard]] std::shared_ptr<const Image> thumbnailOf(const Session& session, const Texture& texture,
                                                       Target target);

/// The name of the image in lists: "Brick wall", "earth.jpg".
[[nodiscard]] std::string nameOfImage(const Texture& texture);

/// The same in the window's language; names of files are not translated.
[[nodiscard]] std::string shownNameOfImage(const Texture& texture);

/// The texture of a unit in a scene; nullptr: none.
[[nodiscard]] const Texture* textureOf(const Scene& scene, const Unit& unit);

} // namespace texplorer::ui
