#pragma once

// The fields of BMP headers as tables, for the anatomy. Private to the BMP codec.

#include "core/codec/bmp/bmp_header.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace texplorer::bmp {

struct FieldContext {
    ByteView file;
    const Header& header; // NOLINT(cppcoreguidelines-avoid-const-or-ref-data-members): lives for one call
};

/// How a field's number is written.
enum class Show : std::uint8_t { Letters, Number, Signed, Compression, Mask, ColorSpace, Fixed16, Fixed30 };

struct FieldRow {
    std::size_t offset; ///< in the file
    std::size_t size;
    std::string_view name;
    std::string_view meaning;
    Show show = Show::Number;
    /// What is wrong with the value, or nothing. nullptr: nothing can be.
    std::string (*check)(std::int64_t value, const FieldContext& context) = nullptr;
};

[[nodiscard]] std::span<const FieldRow> fileHeaderFields();
/// Of a header of that size; those of a longer one may follow them in the table. An unknown size has but
/// itself.
[[nodiscard]] std::span<const FieldRow> infoHeaderFields(std::uint32_t headerSize);
/// Behind a header of 40 bytes.
[[nodiscard]] std::span<const FieldRow> maskFields();

[[nodiscard]] std::string valueOf(const FieldRow& row, const FieldContext& context);
[[nodiscard]] std::string wrongOf(const FieldRow& row, const FieldContext& context);

/// "#ff8000"
[[nodiscard]] std::string hexColor(std::byte red, std::byte green, std::byte blue);

} // namespace texplorer::bmp
