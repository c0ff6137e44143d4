#pragma once

// The table that the scripts of the three shells are written from.

#include "app/command_line/command_line.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// What is offered after the name of an option, or as an argument.
enum class Offered { Nothing, Files, Folders, Words, Joined, Assigned };

/// An option or a positional argument.
struct CompletionRow {
    std::vector<std::string> names; ///< "-o" and "--out"; "FILE" for an argument
    std::string value;              ///< "FILE"; empty: a flag
    std::string summary;            ///< the first sentence of its help, without its full stop
    Offered offered = Offered::Nothing;
    std::vector<std::string> words{};
    bool isList = false;    ///< can be given several times
    bool takesMany = false; ///< of an option: a list that takes all values that follow it
};

struct CompletionTable {
    std::string command; ///< "shot"; empty: the program itself
    std::string summary;
    std::vector<CompletionRow> options; ///< including those that every command has
    std::vector<CompletionRow> arguments;
};

/// The program, followed by its commands in their order.
[[nodiscard]] std::vector<CompletionTable> completionTables(const CommandLine& line);

/// The parameters that its options assign to; empty: none.
[[nodiscard]] std::vector<Assigned> assignedBy(const CommandLine& line);

[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view separator = " ");

/// Quoted as one word of bash and zsh.
[[nodiscard]] std::string singleQuoted(std::string_view text);

[[nodiscard]] std::string bashCompletion(const CommandLine& line);
[[nodiscard]] std::string zshCompletion(const CommandLine& line);
[[nodiscard]] std::string fishCompletion(const CommandLine& line);

} // namespace texplorer
