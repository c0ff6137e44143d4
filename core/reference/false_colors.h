#pragma once

#include "core/gl/enum_row.h"
#include "core/image/image.h"
#include "core/reference/level_map.h"

#include <array>
#include <cstdint>

namespace texplorer::reference {

/// What a view shows of a scene: its picture, or of one texture unit a number for each pixel, as a colour.
enum class Shown : std::uint32_t { Picture, Lambda, Anisotropy };

inline constexpr std::array shownRows{
    row(Shown::Picture, "picture", "Picture", "What the renderers draw."),
    row(Shown::Lambda, "lambda", "λ",
        "The level of detail at each pixel, from the base level, dark violet, to the last one, yellow; black where "
        "λ is 0 or less: magnified."),
    row(Shown::Anisotropy, "anisotropy", "Anisotropy",
        "How many times as long as wide the footprint of each pixel is in the texture: 1 is dark violet, 16 and "
        "more yellow."),
};

inline constexpr float largestShownRatio = 16; ///< what is beyond has the same colour

/// The colour of a level of detail where `steps` levels, at least 1, lie above the base. Opaque.
[[nodiscard]] std::array<std::uint8_t, 4> lambdaColor(float lambda, int steps);

/// The colour of a footprint's ratio: equal steps from 1 to 2, to 4, to 8 and to 16. Opaque.
[[nodiscard]] std::array<std::uint8_t, 4> ratioColor(float ratio);

/// How many levels above the base the colours of λ are for: 1 where there is none.
[[nodiscard]] int stepsOf(const LevelMap& map);

/// Each pixel as its colour: Rgba8, bottom row first, transparent where nothing was sampled.
[[nodiscard]] Image falseColors(const LevelMap& map, Shown shown);

} // namespace texplorer::reference

template<>
struct texplorer::EnumTable<texplorer::reference::Shown> {
    static constexpr std::span<const EnumRow> rows = texplorer::reference::shownRows;
};
static_assert(texplorer::reference::shownRows.size() == 3);
