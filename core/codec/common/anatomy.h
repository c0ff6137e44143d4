#pragma once

// What is where in a file: offset, size, name, raw bytes, value, meaning. For people who look at a file
// because something is wrong with it, so it goes on to the point of damage and says what looks wrong.

#include "core/base/bytes.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

struct Field {
    std::uint64_t offset = 0;
    std::uint64_t size = 0; ///< bytes that the field should have; the file may end before
    std::string name;       ///< as its specification names it: "biBitCount"
    std::string value;      ///< decoded: "24", "54 (0x36)", "DXT5"
    std::string meaning;    ///< "bits a pixel"
    std::string wrong;      ///< empty, or what looks wrong: "expected 40, 108 or 124"
    int depth = 0;          ///< nesting: 0 a section ("BITMAPINFOHEADER", "IHDR"), 1 its fields
};

struct Anatomy {
    std::string_view format;   ///< "BMP"
    std::vector<Field> fields; ///< in file order; bounded (at most 4096)
    std::string damage;        ///< empty, or where and why reading stopped
};

// One function a format, each beside its decoder; registry.h chooses.

/// The bytes of a field that exist in the file.
[[nodiscard]] inline ByteView bytesOf(const Field& field, ByteView file) {
    return partOf(file, field.offset, field.size);
}

} // namespace texplorer
