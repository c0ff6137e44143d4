#pragma once

#include "texplorer/base/translatable.h"

#include <array>
#include <string_view>

namespace texplorer::animation {

enum class Format { Gif, WebP, Apng };

/// What a format of animations supports.
struct FormatRow {
    Format format;
    std::string_view name;
    std::string_view extension;
    int unitsPerSecond; ///< units of durations in its files, per second
    int maxShownUnits;  ///< the longest duration of a picture, in units
    int maxPerSecond;   ///< pictures per second that viewers can follow
    int maxExtent;      ///< pixels along each axis
};

/// APNG files have the extension of PNG. GIF: viewers show a delay below two hundredths as a tenth.
inline constexpr std::array formatRows{
    FormatRow{Format::Gif, "GIF", ".gif", 100, 65535, 50, 65535},
    FormatRow{Format::WebP, N_("WebP"), ".webp", 1000, 0xffffff, 1000, 16383},
    FormatRow{Format::Apng, "APNG", ".png", 1000, 65535, 1000, 65535},
};

[[nodiscard]] constexpr const FormatRow& rowOf(Format format) {
    return formatRows[static_cast<std::size_t>(format)];
}

/// Finds the format by a file name's extension, in any case. Returns nullptr for an unknown one.
[[nodiscard]] const FormatRow* formatOfName(std::string_view name);

} // namespace texplorer::animation
