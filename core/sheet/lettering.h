#pragma once

#include "texplorer/image/image.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace texplorer::sheet {

/// The role of a line, which decides its size.
enum class TextRole : std::uint8_t { Title, Heading, Label, Note };

inline constexpr std::size_t textRoleCount = 4;

using Ink = std::array<std::uint8_t, 3>; ///< red, green, blue

/// Writes the texts of a sheet in a font of the program. Lengths are in pixels. Must be thread-safe.
class Lettering {
public:
    Lettering() = default;
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;
    virtual ~Lettering() = default;

    /// The width of a line of UTF-8, rounded up.
    [[nodiscard]] virtual int width(TextRole role, std::string_view text) const = 0;
    /// The distance between lines.
    [[nodiscard]] virtual int lineHeight(TextRole role) const = 0;
    /// Draws into an Rgb8 picture. `left` and `top` of the line's box are relative to the picture's upper
    /// left; what is outside is clipped.
    virtual void draw(Image& picture, int left, int top, TextRole role, std::string_view text,
                      Ink ink) const = 0;
};

} // namespace texplorer::sheet
