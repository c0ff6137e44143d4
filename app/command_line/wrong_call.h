#pragma once

#include "texplorer/base/sentence.h"

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// The error of a wrong call in one sentence, without the program's name. `program` is the whole program,
/// `called` the command as the user writes it, "texshot shot".
[[nodiscard]] Sentence sentenceFor(const CLI::App& program, const std::string& called,
                                   const CLI::ParseError& error);

/// `; did you mean "shot" or "show"?`: names that begin with the misspelt one, or similar ones; empty if
/// there are none.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string_view>& names);

/// The same for an option: "; did you mean --size?"
[[nodiscard]] std::string didYouMeanOption(const CLI::App& app, std::string_view word);

} // namespace texplorer
