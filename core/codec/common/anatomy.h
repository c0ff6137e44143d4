#pragma once

// The structure of a file: offset, size, name, raw bytes, value and meaning of each field. It is used to
// examine broken files, so it continues up to the damage and reports what looks wrong.

#include "texplorer/base/bytes.h"
#include "texplorer/base/sentence.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

struct Field {
    std::uint64_t offset = 0;
    std::uint64_t size = 0; ///< the bytes that the field should have; the file may end earlier
    Sentence name;          ///< the name in the specification: "biBitCount"
    Sentence value;         ///< decoded: "24", "54 (0x36)", "DXT5"
    Sentence meaning;       ///< "bits a pixel"
    Sentence wrong;         ///< empty, or what looks wrong: "expected 40, 108 or 124"
    int depth = 0;          ///< nesting: 0 a section ("BITMAPINFOHEADER", "IHDR"), 1 its fields
};

struct Anatomy {
    std::string_view format;   ///< "BMP"
    std::vector<Field> fields; ///< in file order; bounded (at most 4096)
    Sentence damage;           ///< empty, or where and why the analysis stopped
};

// Each format has one such function, next to its decoder; registry.h chooses.

/// Returns the bytes of a field that exist in the file.
[[nodiscard]] inline ByteView bytesOf(const Field& field, ByteView file) {
    return partOf(file, field.offset, field.size);
}

} // namespace texplorer
