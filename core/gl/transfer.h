#pragma once

// How pixels lie in a program's memory when glTexImage reads them: OpenGL 2.1, section 3.6.4. Colour indices,
// stencil indices and GL_BITMAP are missing: textures with colours don't take them.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

/// Table 3.6.
enum class TransferFormat : std::uint32_t {
    DepthComponent = 0x1902,
    Red = 0x1903,
    Green = 0x1904,
    Blue = 0x1905,
    Alpha = 0x1906,
    Rgb = 0x1907,
    Rgba = 0x1908,
    Luminance = 0x1909,
    LuminanceAlpha = 0x190A,
    Bgr = 0x80E0,
    Bgra = 0x80E1,
};

/// Table 3.5.
enum class TransferType : std::uint32_t {
    Byte = 0x1400,
    UnsignedByte = 0x1401,
    Short = 0x1402,
    UnsignedShort = 0x1403,
    Int = 0x1404,
    UnsignedInt = 0x1405,
    Float = 0x1406,
    UnsignedByte332 = 0x8032,
    UnsignedShort4444 = 0x8033,
    UnsignedShort5551 = 0x8034,
    UnsignedInt8888 = 0x8035,
    UnsignedInt1010102 = 0x8036,
    UnsignedByte233Rev = 0x8362,
    UnsignedShort565 = 0x8363,
    UnsignedShort565Rev = 0x8364,
    UnsignedShort4444Rev = 0x8365,
    UnsignedShort1555Rev = 0x8366,
    UnsignedInt8888Rev = 0x8367,
    UnsignedInt2101010Rev = 0x8368,
};

struct TransferFormatFacts {
    TransferFormat format;
    std::string_view components; ///< in their order in memory: letters of "rgba", 'l' and 'd' (depth)
};

inline constexpr std::array transferFormatFacts{
    TransferFormatFacts{TransferFormat::Rgb, "rgb"},
    TransferFormatFacts{TransferFormat::Rgba, "rgba"},
    TransferFormatFacts{TransferFormat::Bgr, "bgr"},
    TransferFormatFacts{TransferFormat::Bgra, "bgra"},
    TransferFormatFacts{TransferFormat::Luminance, "l"},
    TransferFormatFacts{TransferFormat::LuminanceAlpha, "la"},
    TransferFormatFacts{TransferFormat::Alpha, "a"},
    TransferFormatFacts{TransferFormat::Red, "r"},
    TransferFormatFacts{TransferFormat::Green, "g"},
    TransferFormatFacts{TransferFormat::Blue, "b"},
    TransferFormatFacts{TransferFormat::DepthComponent, "d"},
};

/// A packed type holds all components of a pixel in one number.
struct TransferTypeFacts {
    TransferType type;
    int bytes; ///< of the number
    std::array<std::uint8_t, 4>
        bits{};              ///< of a packed type's fields, from the highest one; tables 3.8 to 3.10
    bool isReversed = false; ///< the first component is in the lowest field (_REV)

    [[nodiscard]] constexpr bool isPacked() const { return bits[0] != 0; }
    /// The components that a packed type has.
    [[nodiscard]] constexpr int fields() const { return bits[3] != 0 ? 4 : 3; }
};

inline constexpr std::array transferTypeFacts{
    TransferTypeFacts{TransferType::UnsignedByte, 1},
    TransferTypeFacts{TransferType::Byte, 1},
    TransferTypeFacts{TransferType::UnsignedShort, 2},
    TransferTypeFacts{TransferType::Short, 2},
    TransferTypeFacts{TransferType::UnsignedInt, 4},
    TransferTypeFacts{TransferType::Int, 4},
    TransferTypeFacts{TransferType::Float, 4},
    TransferTypeFacts{TransferType::UnsignedByte332, 1, {3, 3, 2, 0}},
    TransferTypeFacts{TransferType::UnsignedByte233Rev, 1, {2, 3, 3, 0}, true},
    TransferTypeFacts{TransferType::UnsignedShort565, 2, {5, 6, 5, 0}},
    TransferTypeFacts{TransferType::UnsignedShort565Rev, 2, {5, 6, 5, 0}, true},
    TransferTypeFacts{TransferType::UnsignedShort4444, 2, {4, 4, 4, 4}},
    TransferTypeFacts{TransferType::UnsignedShort4444Rev, 2, {4, 4, 4, 4}, true},
    TransferTypeFacts{TransferType::UnsignedShort5551, 2, {5, 5, 5, 1}},
    TransferTypeFacts{TransferType::UnsignedShort1555Rev, 2, {1, 5, 5, 5}, true},
    TransferTypeFacts{TransferType::UnsignedInt8888, 4, {8, 8, 8, 8}},
    TransferTypeFacts{TransferType::UnsignedInt8888Rev, 4, {8, 8, 8, 8}, true},
    TransferTypeFacts{TransferType::UnsignedInt1010102, 4, {10, 10, 10, 2}},
    TransferTypeFacts{TransferType::UnsignedInt2101010Rev, 4, {2, 10, 10, 10}, true},
};

[[nodiscard]] constexpr std::string_view componentsOf(TransferFormat format) {
    const auto* found = std::ranges::find(transferFormatFacts, format, &TransferFormatFacts::format);
    return found == transferFormatFacts.end() ? std::string_view("rgba") : found->components;
}
[[nodiscard]] constexpr const TransferTypeFacts& factsOf(TransferType type) {
    const auto* found = std::ranges::find(transferTypeFacts, type, &TransferTypeFacts::type);
    return found == transferTypeFacts.end() ? transferTypeFacts.front() : *found;
}

inline constexpr std::array transferFormatRows{
    row(TransferFormat::Rgb, "GL_RGB", "RGB", "Red, green, blue.", "1.0"),
    row(TransferFormat::Rgba, "GL_RGBA", "RGBA", "Red, green, blue, alpha.", "1.0"),
    row(TransferFormat::Bgr, "GL_BGR", "BGR", "Blue, green, red: the order in BMP and TGA files.", "1.2"),
    row(TransferFormat::Bgra, "GL_BGRA", "BGRA", "Blue, green, red, alpha.", "1.2"),
    row(TransferFormat::Luminance, "GL_LUMINANCE", N_("Luminance"), "One number for red, green and blue.",
        "1.0"),
    row(TransferFormat::LuminanceAlpha, "GL_LUMINANCE_ALPHA", N_("Luminance + alpha"),
        "One number for red, green and blue, then alpha.", "1.0"),
    row(TransferFormat::Alpha, "GL_ALPHA", N_("Alpha"), "Alpha alone: the colour is black.", "1.0"),
    row(TransferFormat::Red, "GL_RED", N_("Red"), "Red alone: green and blue are 0.", "1.0"),
    row(TransferFormat::Green, "GL_GREEN", N_("Green"), "Green alone: red and blue are 0.", "1.0"),
    row(TransferFormat::Blue, "GL_BLUE", N_("Blue"), "Blue alone: red and green are 0.", "1.0"),
    row(TransferFormat::DepthComponent, "GL_DEPTH_COMPONENT", N_("Depth"),
        "A depth: for depth textures alone, which take nothing else.", "1.4"),
};

inline constexpr std::array transferTypeRows{
    row(TransferType::UnsignedByte, "GL_UNSIGNED_BYTE", N_("Byte, 0 to 255"), "8 bits a component.", "1.0"),
    row(TransferType::Byte, "GL_BYTE", N_("Signed byte"),
        "8 bits a component, -128 to 127: c becomes (2c + 1) / 255, and what is below 0 becomes 0.", "1.0"),
    row(TransferType::UnsignedShort, "GL_UNSIGNED_SHORT", N_("Short, 0 to 65535"), "16 bits a component.",
        "1.0"),
    row(TransferType::Short, "GL_SHORT", N_("Signed short"),
        "16 bits a component, -32768 to 32767: c becomes (2c + 1) / 65535.", "1.0"),
    row(TransferType::UnsignedInt, "GL_UNSIGNED_INT", N_("Integer, from 0"), "32 bits a component.", "1.0"),
    row(TransferType::Int, "GL_INT", N_("Signed integer"),
        "32 bits a component: c becomes (2c + 1) / (2³² - 1).", "1.0"),
    row(TransferType::Float, "GL_FLOAT", N_("Float"), "The number itself, limited to 0 … 1.", "1.0"),
    row(TransferType::UnsignedByte332, "GL_UNSIGNED_BYTE_3_3_2", "3-3-2",
        "A byte a pixel: 3 bits of the first component at the top.", "1.2"),
    row(TransferType::UnsignedByte233Rev, "GL_UNSIGNED_BYTE_2_3_3_REV", "2-3-3 reversed",
        "A byte a pixel: the first component in the lowest 3 bits.", "1.2"),
    row(TransferType::UnsignedShort565, "GL_UNSIGNED_SHORT_5_6_5", "5-6-5",
        "16 bits a pixel: 5 bits of the first component at the top.", "1.2"),
    row(TransferType::UnsignedShort565Rev, "GL_UNSIGNED_SHORT_5_6_5_REV", "5-6-5 reversed",
        "16 bits a pixel: the first component in the lowest 5 bits.", "1.2"),
    row(TransferType::UnsignedShort4444, "GL_UNSIGNED_SHORT_4_4_4_4", "4-4-4-4",
        "16 bits a pixel: 4 bits of the first component at the top.", "1.2"),
    row(TransferType::UnsignedShort4444Rev, "GL_UNSIGNED_SHORT_4_4_4_4_REV", "4-4-4-4 reversed",
        "16 bits a pixel: the first component in the lowest 4 bits.", "1.2"),
    row(TransferType::UnsignedShort5551, "GL_UNSIGNED_SHORT_5_5_5_1", "5-5-5-1",
        "16 bits a pixel: the fourth component, of one bit, in the lowest one.", "1.2"),
    row(TransferType::UnsignedShort1555Rev, "GL_UNSIGNED_SHORT_1_5_5_5_REV", "1-5-5-5 reversed",
        "16 bits a pixel: the fourth component, of one bit, in the highest one.", "1.2"),
    row(TransferType::UnsignedInt8888, "GL_UNSIGNED_INT_8_8_8_8", "8-8-8-8",
        "32 bits a pixel: the first component in the highest byte, which most processors store last.", "1.2"),
    row(TransferType::UnsignedInt8888Rev, "GL_UNSIGNED_INT_8_8_8_8_REV", "8-8-8-8 reversed",
        "32 bits a pixel: the first component in the lowest byte, which most processors store first.", "1.2"),
    row(TransferType::UnsignedInt1010102, "GL_UNSIGNED_INT_10_10_10_2", "10-10-10-2",
        "32 bits a pixel: the fourth component in the lowest 2 bits.", "1.2"),
    row(TransferType::UnsignedInt2101010Rev, "GL_UNSIGNED_INT_2_10_10_10_REV", "2-10-10-10 reversed",
        "32 bits a pixel: the fourth component in the highest 2 bits.", "1.2"),
};

template<>
struct EnumTable<TransferFormat> {
    static constexpr std::span<const EnumRow> rows = transferFormatRows;
};
template<>
struct EnumTable<TransferType> {
    static constexpr std::span<const EnumRow> rows = transferTypeRows;
};

static_assert(transferFormatRows.size() == 11 && transferFormatFacts.size() == transferFormatRows.size());
static_assert(transferTypeRows.size() == 19 && transferTypeFacts.size() == transferTypeRows.size());

} // namespace texplorer
