#pragma once

// texshot's subcommands: one file each, registered in main.cpp's table.

#include "app/command_line/command_line.h"
#include "core/base/bytes.h"
#include "core/base/result.h"

#include <string>
#include <string_view>

namespace texplorer::screenshot {

enum ExitCode : int {
    success = 0,
    failure = 1,   ///< a file, the driver or the scene: one sentence on standard error says which
    wrongCall = 2, ///< the command line itself: an option, a path or a value that does not exist
    // 128 and a signal's number, as a shell has it, of a program that a signal ended: 130 Ctrl+C
};

void addShot(CommandLine& line);
void addAnimate(CommandLine& line);
void addSweep(CommandLine& line);
void addProbe(CommandLine& line);
void addCheck(CommandLine& line);
void addCompare(CommandLine& line);
void addCommands(CommandLine& line);
void addEmit(CommandLine& line);
void addParams(CommandLine& line);
void addPresets(CommandLine& line);
void addScene(CommandLine& line);
void addValidate(CommandLine& line);
void addDiff(CommandLine& line);
void addDrivers(CommandLine& line);
void addLessons(CommandLine& line);
void addDecode(CommandLine& line);
void addInfo(CommandLine& line);
void addFlip(CommandLine& line);
void addCompress(CommandLine& line);
void addConform(CommandLine& line);
void addConvert(CommandLine& line);
void addSchema(CommandLine& line);
void addTexture(CommandLine& line);
void addTest(CommandLine& line);
void addMerge(CommandLine& line);

/// What --help and the manual say of the commands declared so far beside their options: examples, formats.
void addHelpSections(CommandLine& line);

/// Says what is wrong on standard error, and to who has asked for JSON (output/json_text.h). Returns `code`.
ExitCode complain(const Error& error, ExitCode code = failure);

/// Of an error that was found with the scene: a wrong call where it is about an option, "--level".
[[nodiscard]] inline ExitCode statusOf(const Error& error) {
    return error.code == ErrorCode::OutOfRange && error.where.starts_with("--") ? wrongCall : failure;
}

/// A text of several lines, or JSON, to standard output: printable (core/text/printable.h), its lines kept.
/// Parts that come from outside are made printable before, lest they bring lines of their own.
[[nodiscard]] Result<void> print(std::string_view text);

} // namespace texplorer::screenshot
