#pragma once

#include "texplorer/gl/enum_row.h"
#include "texplorer/image/image.h"
#include "texplorer/reference/level_map.h"

#include <array>
#include <cstdint>

namespace texplorer::reference {

/// What a view shows: the scene's picture, or a number of one texture unit for each pixel, as a colour.
enum class Shown : std::uint32_t { Picture, Lambda, Anisotropy };

inline constexpr std::array shownRows{
    row(Shown::Picture, "picture", "Picture", "The picture of the renderer."),
    row(Shown::Lambda, "lambda", "λ",
        "The level of detail at each pixel, from dark violet (base level) to yellow (last level). Black "
        "where magnified (λ is 0 or less)."),
    row(Shown::Anisotropy, "anisotropy", "Anisotropy",
        "The ratio of length to width of each pixel's footprint in the texture, from dark violet (1) to "
        "yellow (16 and more)."),
};

inline constexpr float maxShownRatio = 16; ///< larger ratios have the same colour

/// The opaque colour of a level of detail in a texture with `steps` levels, at least 1, above the base.
[[nodiscard]] std::array<std::uint8_t, 4> lambdaColor(float lambda, int steps);

/// The opaque colour of a footprint's ratio, with equal steps from 1 to 2, to 4, to 8 and to 16.
[[nodiscard]] std::array<std::uint8_t, 4> ratioColor(float ratio);

/// The number of levels above the base in the colour scale of λ; at least 1.
[[nodiscard]] int stepsOf(const LevelMap& map);

/// The colour of each pixel: Rgba8, bottom row first, transparent where nothing was sampled.
[[nodiscard]] Image falseColors(const LevelMap& map, Shown shown);

} // namespace texplorer::reference

template<>
struct texplorer::EnumTable<texplorer::reference::Shown> {
    static constexpr std::span<const EnumRow> rows = texplorer::reference::shownRows;
};
static_assert(texplorer::reference::shownRows.size() == 3);
