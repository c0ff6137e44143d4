#pragma once

// What the scripts of the three shells have in common: the table that they are written from.

#include "app/command_line/command_line.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// What is typed after an option's name, or as an argument.
enum class Offered { Nothing, Files, Folders, Words, Joined, Assigned };

/// An option, or an argument by its place.
struct CompletionRow {
    std::vector<std::string> names; ///< "-o" and "--out"; of an argument "FILE"
    std::string value;              ///< "FILE"; empty: a flag
    std::string summary;            ///< the first sentence of its help, without its full stop
    Offered offered = Offered::Nothing;
    std::vector<std::string> words{};
    bool isList = false;    ///< may be given again
    bool takesMany = false; ///< of an option: a list that takes all values that follow
};

struct CompletionTable {
    std::string command; ///< "shot"; empty: the program itself
    std::string summary;
    std::vector<CompletionRow> options; ///< those that every command has among them
    std::vector<CompletionRow> arguments;
};

/// The program, and after it its commands in their order.
[[nodiscard]] std::vector<CompletionTable> completionTables(const CommandLine& line);

/// What its options assign to; empty: none does.
[[nodiscard]] std::vector<Assigned> assignedBy(const CommandLine& line);

[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view separator = " ");

/// As one word of bash and zsh.
[[nodiscard]] std::string singleQuoted(std::string_view text);

[[nodiscard]] std::string bashCompletion(const CommandLine& line);
[[nodiscard]] std::string zshCompletion(const CommandLine& line);
[[nodiscard]] std::string fishCompletion(const CommandLine& line);

} // namespace texplorer
