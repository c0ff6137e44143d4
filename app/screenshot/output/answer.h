#pragma once

// What a call ends with: its answer, or why there is none, and its exit status.

#include "texplorer/base/result.h"

#include <functional>
#include <string_view>

namespace texplorer::screenshot {

enum ExitCode : int {
    success = 0,
    failure = 1,   ///< a file, the driver or the scene: one sentence on standard error says which
    wrongCall = 2, ///< the command line itself: an option, a path or a value that does not exist
    // 128 and a signal's number, as a shell has it, of a program that a signal ended: 130 Ctrl+C
};

/// Says what is wrong on standard error, and to who has asked for JSON (json_text.h). Returns `code`.
ExitCode complain(const Error& error, ExitCode code = failure);

/// Of an error that was found with the scene: a wrong call where it is about an option, "--level".
[[nodiscard]] inline ExitCode statusOf(const Error& error) {
    return error.code == ErrorCode::OutOfRange && error.where.isOf(Location::Kind::Option) ? wrongCall
                                                                                           : failure;
}

/// A text of several lines, or JSON, to standard output: printable (core/text/printable.h), its lines kept.
/// Parts that come from outside are made printable before, so that they bring no lines of their own.
[[nodiscard]] Result<void> print(std::string_view text);

using Print = std::function<Result<void>(std::string_view)>;

/// The same in pieces: `make` prints them.
[[nodiscard]] Result<void> printPieces(const std::function<Result<void>(const Print&)>& make);

/// The call asks for a document on standard output (json_text.h): it prints one, also if it fails. Call it
/// before other threads run.
void expectDocument();

/// Prints the document of a call that has failed, if one is expected and nothing was printed.
void printProblems();

} // namespace texplorer::screenshot
