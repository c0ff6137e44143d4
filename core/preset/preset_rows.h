#pragma once

// The presets by their group, and what they have in common.

#include "core/preset/preset.h"

namespace texplorer::preset {

[[nodiscard]] std::span<const Preset> alphaPresets();
[[nodiscard]] std::span<const Preset> coordinatePresets(); ///< that move, and those that are generated
[[nodiscard]] std::span<const Preset> unitPresets();       ///< environments, and several units
[[nodiscard]] std::span<const Preset> filterPresets();

/// The texture shows a pattern with all of its components, and nothing is done to it before.
void showPattern(Texture& texture, Pattern pattern);

/// The same where the texture's picture isn't of a kind that suits.
void showPatternUnless(Texture& texture, Pattern pattern, bool suits);

/// A picture of one's own, from a file, stays.
void showPatternUnlessOwn(Texture& texture, Pattern pattern);

/// Trilinear, with all levels generated.
void filterTrilinear(Texture& texture);

/// The unit shows an image with the coordinates of the vertices, not generated ones; the texture matrix stays
/// but for the light's projector, which is for generated ones.
void generateNothing(Unit& unit);

/// The same without a texture matrix, and for any target.
void takeGivenCoordinates(Unit& unit, Target target = Target::Texture2D);

/// The first unit of the pass behind this one that is off, else before it. The error: all are on.
[[nodiscard]] Result<std::size_t> freeUnit(const PresetTarget& target);

/// A new texture at the end of the scene's. The error: there is no room.
[[nodiscard]] Result<std::size_t> addTexture(Scene& scene, Texture texture);

} // namespace texplorer::preset
