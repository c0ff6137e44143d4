#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// What was wrong with a call, in one sentence without the program's name. `program` is that of the whole,
/// `called` what it is asked for as one would write it, "texshot shot".
[[nodiscard]] std::string sentenceFor(const CLI::App& program, const std::string& called,
                                      const CLI::ParseError& error);

/// `; did you mean "shot" or "show"?`: the names that a misspelt one begins, or those that are close; empty:
/// none is.
[[nodiscard]] std::string didYouMean(std::string_view word, const std::vector<std::string_view>& names);

/// The same of an option: "; did you mean --size?"
[[nodiscard]] std::string didYouMeanOption(const CLI::App& app, std::string_view word);

} // namespace texplorer
