#pragma once

#include "core/image/image.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace texplorer::sheet {

/// What a line of a sheet says decides how large it is written.
enum class TextRole : std::uint8_t { Title, Heading, Label, Note };

inline constexpr std::size_t textRoleCount = 4;

using Ink = std::array<std::uint8_t, 3>; ///< red, green, blue

/// What writes the words of a sheet: a font, as whoever makes the picture has one. Lengths are pixels. From
/// several threads at once.
class Lettering {
public:
    Lettering() = default;
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;
    virtual ~Lettering() = default;

    /// Of a line of UTF-8, rounded up.
    [[nodiscard]] virtual int width(TextRole role, std::string_view text) const = 0;
    /// From one line to the next.
    [[nodiscard]] virtual int lineHeight(TextRole role) const = 0;
    /// Into an Rgb8 picture. `left` and `top` of the line's box are counted from the picture's upper left;
    /// what falls outside is left away.
    virtual void draw(Image& picture, int left, int top, TextRole role, std::string_view text,
                      Ink ink) const = 0;
};

} // namespace texplorer::sheet
