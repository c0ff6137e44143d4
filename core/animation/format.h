#pragma once

#include <array>
#include <string_view>

namespace texplorer::animation {

enum class Format { Gif, WebP, Apng };

/// What a format of animations can.
struct FormatRow {
    Format format;
    std::string_view name;
    std::string_view extension;
    int unitsPerSecond; ///< in which its files say how long a picture is shown
    int mostUnits;      ///< for which one is shown
    int mostPerSecond;  ///< pictures: what viewers go along with
    int mostExtent;     ///< pixels, on each axis
};

/// APNG's extension is PNG's. GIF: viewers take delays below two hundredths for a tenth.
inline constexpr std::array formatRows{
    FormatRow{Format::Gif, "GIF", ".gif", 100, 65535, 50, 65535},
    FormatRow{Format::WebP, "WebP", ".webp", 1000, 0xffffff, 1000, 16383},
    FormatRow{Format::Apng, "APNG", ".png", 1000, 65535, 1000, 65535},
};

[[nodiscard]] constexpr const FormatRow& rowOf(Format format) {
    return formatRows[static_cast<std::size_t>(format)];
}

/// By the end of a name, in whatever case; nullptr: it names none.
[[nodiscard]] const FormatRow* formatOfName(std::string_view name);

} // namespace texplorer::animation
