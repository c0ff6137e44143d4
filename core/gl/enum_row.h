#pragma once

// The vocabulary: one row per enumerant is the only place where its name, label and help are written.
// Panels, JSON, `texshot params`, `--set`, the command view and error messages all read the rows.

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
    std::uint32_t value;      ///< GL's number, or our own for what GL has no enumerant for
    std::string_view name;    ///< GL's name ("GL_REPEAT"), or the word in scene files ("cube")
    std::string_view label;   ///< what a panel shows
    std::string_view help;    ///< one sentence for a student
    std::string_view since;   ///< "1.0", "1.3", or an extension's name; empty for our own words
    std::string_view group{}; ///< what stands above those of a kind in a long list; empty: a short one
    std::string_view brief{}; ///< the label where it has little room, in its group; empty: the label is short
};

/// Specialised beside every enum: `static constexpr std::span<const EnumRow> rows`.
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

/// What a button shows.
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

/// The row of an enumerator. A value without a row is a programming mistake; the first row stands in for it.
template<Enumerated E>
constexpr const EnumRow& rowOf(E value) {
    // Not by findRow: GCC 12 under UBSan takes no comparison of an address with nullptr in a constant
    // expression.
    const auto& rows = EnumTable<E>::rows;
    const auto found = std::ranges::find(rows, static_cast<std::uint32_t>(value), &EnumRow::value);
    return found == rows.end() ? rows.front() : *found;
}

/// "GL_NEAREST, GL_LINEAR": what would have been accepted, for an error message.
[[nodiscard]] inline std::string listNames(std::span<const EnumRow> rows) {
    std::string names;
    for (const EnumRow& each : rows)
        names.append(names.empty() ? "" : ", ").append(each.name);
    return names;
}

} // namespace texplorer
