#pragma once

#include "app/ui/model/session.h"

#include <memory>
#include <string>

namespace texplorer::ui {

/// What there is to say of a texture's levels, with small pictures of its image: made beside the window where
/// that takes long. nullptr: not yet.
[[nodiscard]] std::shared_ptr<const LevelsSummary> summaryOf(Session& session, const Texture& texture,
                                                             Target target);

/// The largest level, small and upright; nullptr: not yet, or there is none.
[[nodiscard]] std::shared_ptr<const Image> thumbnailOf(Session& session, const Texture& texture,
                                                       Target target);

/// "Brick wall", "earth.jpg": what a list calls it.
[[nodiscard]] std::string nameOfImage(const Texture& texture);

/// The same in the window's language; a file keeps its name.
[[nodiscard]] std::string shownNameOfImage(const Texture& texture);

/// The texture that a unit of a scene shows; nullptr: none.
[[nodiscard]] const Texture* textureOf(const Scene& scene, const Unit& unit);

} // namespace texplorer::ui
