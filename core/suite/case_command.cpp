#include "texplorer/suite/case_command.h"

#include "texplorer/text/printable.h"
#include "texplorer/text/shell_word.h"

#include <algorithm>
#include <array>

namespace texplorer::suite {
namespace {

/// Each takes the next word as its value.
constexpr std::array<std::string_view, 3> choices{"--only", "--shard", "--durations"};

/// The first word with the quotes of shellWord; the rest begins with the next word.
std::string_view takeWord(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    std::size_t end = 0;
    bool quoted = false;
    bool printed = false; // "$(printf '…')", with quotes of its own
    for (; end < text.size() && (quoted || printed || text[end] != ' '); ++end) {
        if (text[end] == '\'')
            quoted = !quoted;
        else if (text[end] == '"' && !quoted)
            printed = !printed;
        else if (text[end] == '\\' && !quoted)
            ++end;
    }
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(word.size());
    return word;
}

/// A pattern of --only that fits this name alone.
std::string patternOf(std::string_view name) {
    std::string pattern;
    for (const char each : name) {
        if (std::string_view("*?[\\").find(each) != std::string_view::npos)
            pattern += '\\';
        pattern += each;
    }
    return pattern;
}

} // namespace

std::string commandOfCase(std::string_view runCommand, std::string_view name) {
    if (runCommand.empty() || printable(name) != name)
        return {};
    std::string command;
    for (std::string_view left = runCommand; !left.empty();) {
        const std::string_view word = takeWord(left);
        if (std::ranges::find(choices, word) != choices.end())
            takeWord(left);
        else if (!word.empty())
            command.append(command.empty() ? "" : " ").append(word);
    }
    return command + " --only " + shellWord(patternOf(name));
}

} // namespace texplorer::suite
