#pragma once

#include "app/command_line/offers.h"
#include "core/base/result.h"
#include "core/gl/enum_row.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace texplorer::screenshot {

/// The names that an option accepts, and what was found instead.
[[nodiscard]] inline tl::unexpected<Error> refuseChoice(const std::string& names, std::string_view found,
                                                        const char* option) {
    return fail(ErrorCode::OutOfRange, fmt::format("expected one of {}, found \"{}\"", names, found), option);
}

/// One of the rows, by its name; `option` is named in the error.
template<Enumerated E>
[[nodiscard]] Result<E> parseChoice(std::string_view name, const char* option) {
    const std::span<const EnumRow> rows = EnumTable<E>::rows;
    if (const EnumRow* row = findRow(rows, name))
        return static_cast<E>(row->value);
    return refuseChoice(listNames(rows), name, option);
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

} // namespace texplorer::screenshot
