#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace texplorer {

/// What is said of an exception that nothing expected.
inline constexpr std::string_view ownMistake =
    "this is a mistake in Texplorer; please report it with what led to it";

/// Why work threw, as the end of a sentence: the system's own words where it was the system ("No space left
/// on device"), else `ownMistake`. What a library says of its own insides tells a user nothing.
[[nodiscard]] std::string reasonOf(const std::exception& thrown);

/// Called first by a program: what no thread of it catches ends it by SIGABRT, as without this, with the
/// sentence "PROGRAM: this is a mistake in Texplorer …" on standard error instead of the library's.
void sayWhatNothingCatches(const char* program);

} // namespace texplorer
