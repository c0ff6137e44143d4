#pragma once

#include "texplorer/base/translatable.h"

#include <exception>
#include <string>
#include <string_view>

namespace texplorer {

/// The message for an unexpected exception.
inline constexpr std::string_view ownMistake =
    N_("this is a bug in Texplorer; please report it and how it happened");

/// Describes an exception, as the end of a sentence: the system's message for a system error ("No space left
/// on device"), else `ownMistake`. Messages of libraries mean nothing to users.
[[nodiscard]] std::string reasonOf(const std::exception& thrown);

/// Called first by a program: for an uncaught exception on any thread, prints "PROGRAM: this is a mistake in
/// Texplorer …" to standard error instead of the library's message. The program still ends with SIGABRT.
void sayWhatNothingCatches(const char* program);

} // namespace texplorer
