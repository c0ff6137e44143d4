#pragma once

// The presets by group, and functions that they share.

#include "texplorer/preset/preset.h"

namespace texplorer::preset {

[[nodiscard]] std::span<const Preset> alphaPresets();
[[nodiscard]] std::span<const Preset> coordinatePresets(); ///< given, moved and generated coordinates
[[nodiscard]] std::span<const Preset> unitPresets();       ///< environments, and several units
[[nodiscard]] std::span<const Preset> filterPresets();
[[nodiscard]] std::span<const Preset> uploadPresets(); ///< calls that do not fit the program's memory

/// Sets the texture's image to a pattern with all of its components, read as it is, without preparation.
void showPattern(Texture& texture, Pattern pattern);

/// The same, unless the current image is suitable.
void showPatternUnless(Texture& texture, Pattern pattern, bool suits);

/// The same, unless the image is from a file.
void showPatternUnlessOwn(Texture& texture, Pattern pattern);

/// Sets trilinear filtering, with all levels generated.
void filterTrilinear(Texture& texture);

/// Samples a 2D texture at the vertices' coordinates: disables generation and embossing, and removes the
/// projector steps of the texture matrix, which need generated coordinates.
void generateNothing(Unit& unit);

/// The same, and resets the texture matrix; for any target.
void takeGivenCoordinates(Unit& unit, Target target = Target::Texture2D);

/// Shows a floor alone that recedes into the distance, with its own coordinates.
void showFloor(const PresetTarget& target);

/// Behind a sprite with a dark edge. Other presets replace it by the default.
inline constexpr glm::vec4 paper{1};

/// Shows one square alone, seen straight from the front, and returns it.
Model& showSquare(Scene& scene);

/// Returns the first disabled unit after this one, else before it. Error: all are enabled.
[[nodiscard]] Result<std::size_t> freeUnit(const PresetTarget& target);

/// Appends a texture to the scene's. Error: there is no room.
[[nodiscard]] Result<std::size_t> addTexture(Scene& scene, Texture texture);

} // namespace texplorer::preset
