#pragma once

#include "app/command_line/offers.h"
#include "texplorer/base/result.h"
#include "texplorer/gl/enum_row.h"
#include "texplorer/text/nearest_name.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// What was meant, or else the names that an option accepts.
[[nodiscard]] inline tl::unexpected<Error> refuseChoice(const std::vector<std::string>& names,
                                                        std::string_view found, const char* option) {
    const std::string_view near = nearestName(found, {names.begin(), names.end()});
    return fail(ErrorCode::OutOfRange,
                near.empty() ? Sentence("expected one of {0}, found \"{1}\"",
                                        fmt::format("{}", fmt::join(names, ", ")), ProperName{found})
                             : Sentence("there is no \"{0}\"; did you mean \"{1}\"?", ProperName{found},
                                        ProperName{near}),
                atOption(option));
}

/// In small letters or capitals: "DXT1" is "dxt1".
[[nodiscard]] inline bool isSameName(std::string_view a, std::string_view b) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, {}, small, small);
}

/// nullptr: none has that name.
[[nodiscard]] inline const EnumRow* findChoice(std::span<const EnumRow> rows, std::string_view name) {
    const auto row =
        std::ranges::find_if(rows, [name](const EnumRow& each) { return isSameName(each.name, name); });
    return row != rows.end() ? &*row : nullptr;
}

/// One of the rows, by its name; `option` is named in the error.
template<Enumerated E>
[[nodiscard]] Result<E> parseChoice(std::string_view name, const char* option) {
    const std::span<const EnumRow> rows = EnumTable<E>::rows;
    if (const EnumRow* row = findChoice(rows, name))
        return static_cast<E>(row->value);
    return refuseChoice(namesIn(rows), name, option);
}

/// The names of all rows, for what a shell offers.
template<Enumerated E>
[[nodiscard]] std::vector<std::string> choiceNames() {
    return namesIn(EnumTable<E>::rows);
}

/// For a help text, what each choice is: " probes: … ellipse: …"
template<Enumerated E>
[[nodiscard]] std::string explainChoices() {
    std::string text;
    for (const EnumRow& row : EnumTable<E>::rows)
        text += fmt::format(" {}: {}", row.name, row.help);
    return text;
}

} // namespace texplorer
