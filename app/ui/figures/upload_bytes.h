#pragma once

// The bytes of a program's memory: what each is, which texel reads it, and what is wrong.

#include "texplorer/base/sentence.h"
#include "texplorer/scene/upload.h"

#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// An image in a program's memory, and the call that reads it. A volume is its slices one above the other.
struct UploadBytes {
    MemoryLayout held{};
    UploadCall call{};
    PixelExtent extent{};

    [[nodiscard]] std::size_t heldStride() const {
        return rowStride({held.pixels, {.alignment = held.alignment}}, extent.width);
    }
    [[nodiscard]] std::size_t readStride() const { return rowStride(call, extent.width); }
    [[nodiscard]] std::size_t heldBytes() const {
        return heldStride() * static_cast<std::size_t>(extent.height);
    }
};

/// What the program holds in a byte.
struct HeldByte {
    enum class Kind { Component, Packed, Padding, Beyond };
    Kind kind = Kind::Beyond;
    char component = 0; ///< a letter of componentsOf(); of Kind::Component
    int x = 0;          ///< of its pixel, or of the row with the padding
    int y = 0;

    bool operator==(const HeldByte&) const = default;
};
[[nodiscard]] HeldByte heldByte(const UploadBytes& bytes, std::size_t byte);

struct TexelPlace {
    int x = 0;
    int y = 0; ///< 0 is the first row in memory

    bool operator==(const TexelPlace&) const = default;
};

/// The texel that reads a byte: that of the last row, as a short row length makes rows overlap.
[[nodiscard]] std::optional<TexelPlace> readerOf(const UploadBytes& bytes, std::size_t byte);

/// What is wrong with the call as a whole, or that it fits.
[[nodiscard]] Sentence verdictOn(const UploadBytes& bytes);

/// "Texel (3, 2) = bytes 33 to 35 of the memory: b g r, read as r g b"
[[nodiscard]] Sentence wordsOf(const UploadBytes& bytes, TexelPlace texel);

/// "Byte 33: b of pixel (1, 2); read by texel (3, 2)"
[[nodiscard]] Sentence wordsOf(const UploadBytes& bytes, std::size_t byte);

} // namespace texplorer::ui
