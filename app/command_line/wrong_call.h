#pragma once

#include "texplorer/base/result.h"

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// Of a value that a check of ours refuses. No ValidationError: of those CLI11 keeps no more than the text.
struct WrongValue : CLI::ParseError {
    WrongValue(const CLI::Option& option, const Sentence& message)
        : CLI::ParseError("WrongValue", message, CLI::ExitCodes::ValidationError)
        , error{ErrorCode::OutOfRange, message, atOption(option.get_name())} {}
    texplorer::Error error;
};

/// The error of a wrong call. `program` is the whole program, `called` the command as the user writes it,
/// "texshot shot".
[[nodiscard]] Error errorFor(const CLI::App& program, const std::string& called,
                             const CLI::ParseError& error);

/// `"shot" or "show"`: names that begin with the misspelt one, or similar ones; empty if there are none.
[[nodiscard]] Sentence meantBy(std::string_view word, const std::vector<std::string_view>& names);

/// The same for an option: "--size"
[[nodiscard]] Sentence optionMeantBy(const CLI::App& app, std::string_view word);

} // namespace texplorer
