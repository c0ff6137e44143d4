#pragma once

// texshot's subcommands: one file each, registered in main.cpp's table.

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace texplorer::screenshot {

enum ExitCode : int {
    success = 0,
    failure = 1,   ///< a file, the driver or the scene: one sentence on standard error says which
    wrongCall = 2, ///< the command line itself: an option, a path or a value that does not exist
    // 128 and a signal's number, as a shell has it, of a program that a signal ended: 130 Ctrl+C
};

/// What the chosen subcommand does once the command line is parsed.
using Action = std::function<ExitCode()>;

void addShot(CLI::App& app, Action& action);
void addProbe(CLI::App& app, Action& action);
void addCheck(CLI::App& app, Action& action);
void addParams(CLI::App& app, Action& action);
void addDecode(CLI::App& app, Action& action);
void addInfo(CLI::App& app, Action& action);
void addFlip(CLI::App& app, Action& action);
void addCompress(CLI::App& app, Action& action);
void addConform(CLI::App& app, Action& action);
void addConvert(CLI::App& app, Action& action);

/// Prints "texshot: …" on standard error, a printable line, and returns `code`.
ExitCode complain(const Error& error, ExitCode code = failure);

/// A text of several lines, or JSON, to standard output: printable (core/base/printable.h), its lines kept.
/// Parts that come from outside are made printable before, lest they bring lines of their own.
[[nodiscard]] Result<void> print(std::string_view text);

} // namespace texplorer::screenshot
