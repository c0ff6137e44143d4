#pragma once

// The vocabulary: one row per enumerant. Its name, label and help are written nowhere else; panels, JSON,
// `texshot params`, `--set`, the command view and error messages read the rows.

#include "texplorer/base/translatable.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace texplorer {

struct EnumRow {
    std::uint32_t value;    ///< GL's number, or our own where GL has no enumerant
    std::string_view name;  ///< GL's or GLU's name ("GL_REPEAT"), or the name in scene files ("cube")
    std::string_view label; ///< shown in panels
    std::string_view help;  ///< one sentence for a student
    std::string_view
        since; ///< the first version, "1.0" or "1.3", or an extension's name; empty for our own names
    std::string_view group{}; ///< the heading of its group in a long list; empty: a short list
    std::string_view brief{}; ///< a short label, for narrow controls in its group; empty: the label is short
};

/// Specialised next to every enum: `static constexpr std::span<const EnumRow> rows`.
template<class E>
struct EnumTable;

template<class E>
concept Enumerated = std::is_enum_v<E> && requires {
    { EnumTable<E>::rows } -> std::convertible_to<std::span<const EnumRow>>;
};

template<class E>
constexpr EnumRow row(E value, std::string_view name, std::string_view label, std::string_view help,
                      std::string_view since = {}) {
    return {static_cast<std::uint32_t>(value), name, label, help, since};
}

/// The text of a button.
[[nodiscard]] constexpr std::string_view briefOf(const EnumRow& row) {
    return row.brief.empty() ? row.label : row.brief;
}

/// The row with this number, or nullptr.
constexpr const EnumRow* findRow(std::span<const EnumRow> rows, std::uint32_t value) {
    const auto found = std::ranges::find(rows, value, &EnumRow::value);
    return found == rows.end() ? nullptr : &*found;
}

/// The row with this name, or nullptr.
constexpr const EnumRow* findRow(std::span<const EnumRow> rows, std::string_view name) {
    const auto found = std::ranges::find(rows, name, &EnumRow::name);
    return found == rows.end() ? nullptr : &*found;
}

/// The row of an enumerator. A value without a row is a programming error; the first row is returned.
template<Enumerated E>
constexpr const EnumRow& rowOf(E value) {
    // Not findRow: GCC 12 under UBSan rejects the comparison of an address with nullptr in a constant
    // expression.
    const auto& rows = EnumTable<E>::rows;
    const auto found = std::ranges::find(rows, static_cast<std::uint32_t>(value), &EnumRow::value);
    return found == rows.end() ? rows.front() : *found;
}

/// "GL_NEAREST, GL_LINEAR": the accepted values, for an error message.
[[nodiscard]] inline std::string listNames(std::span<const EnumRow> rows) {
    std::string names;
    for (const EnumRow& each : rows)
        names.append(names.empty() ? "" : ", ").append(each.name);
    return names;
}

} // namespace texplorer
