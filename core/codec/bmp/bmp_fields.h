#pragma once

// The fields of BMP headers as tables, for the anatomy. Private to the BMP codec.

#include "texplorer/base/sentence.h"
#include "texplorer/codec/bmp/bmp_header.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace texplorer::bmp {

struct FieldContext {
    ByteView file;
    const Header& header; // NOLINT(cppcoreguidelines-avoid-const-or-ref-data-members): lives for one call
};

/// How the number of a field is shown.
enum class Show : std::uint8_t { Letters, Number, Signed, Compression, Mask, ColorSpace, Fixed16, Fixed30 };

struct FieldRow {
    std::size_t offset; ///< in the file
    std::size_t size;
    std::string_view name;
    std::string_view meaning;
    Show show = Show::Number;
    /// Returns what is wrong with the value, or an empty text. nullptr: every value is valid.
    Sentence (*check)(std::int64_t value, const FieldContext& context) = nullptr;
};

[[nodiscard]] std::span<const FieldRow> fileHeaderFields();
/// The fields of a header of that size; fields of longer headers may follow in the table. For an unknown
/// size, only the size field.
[[nodiscard]] std::span<const FieldRow> infoHeaderFields(std::uint32_t headerSize);
/// The masks that follow a header of 40 bytes.
[[nodiscard]] std::span<const FieldRow> maskFields();

[[nodiscard]] Sentence valueOf(const FieldRow& row, const FieldContext& context);
[[nodiscard]] Sentence wrongOf(const FieldRow& row, const FieldContext& context);

/// "#ff8000"
[[nodiscard]] std::string hexColor(std::byte red, std::byte green, std::byte blue);

} // namespace texplorer::bmp
