#include "app/command_line/help_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <string_view>

namespace texplorer {
namespace {

constexpr std::size_t textColumn = 26;
constexpr std::size_t commandColumn = 14; // the names of commands are short
constexpr std::size_t lineLength = 80;

/// Removes the first line from the words and returns it.
std::string_view takeLine(std::string_view& words, std::size_t room) {
    std::size_t end = words.size();
    if (end > room) {
        end = words.rfind(' ', room);
        if (end == std::string_view::npos)
            end = std::min(words.find(' '), words.size());
    }
    const std::string_view line = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    return line;
}

std::string paragraph(std::string_view words) {
    std::string text;
    do {
        text += takeLine(words, lineLength);
        text += '\n';
    } while (!words.empty());
    return text;
}

/// The name on the left with the words to the right of it, or below it if the name is long.
std::string entry(const std::string& name, std::string_view words, std::size_t textAt = textColumn) {
    std::string text = "  " + name;
    std::size_t column = text.size();
    if (column >= textAt) {
        text += '\n';
        column = 0;
    }
    while (!words.empty()) {
        text.append(textAt - column, ' ');
        text += takeLine(words, lineLength - textAt);
        text += '\n';
        column = 0;
    }
    if (text.back() != '\n')
        text += '\n';
    return text;
}

/// Of "INT in [0 - 30]", as a validator of CLI11 describes itself: "0 to 30".
std::string rangeIn(std::string_view described) {
    const std::size_t begin = described.find('[');
    const std::size_t middle = described.find(" - ");
    const std::size_t end = described.find(']');
    if (begin == std::string_view::npos || middle == std::string_view::npos || end == std::string_view::npos)
        return {};
    return fmt::format("{} to {}", described.substr(begin + 1, middle - begin - 1),
                       described.substr(middle + 3, end - middle - 3));
}

/// Printed as typed, without line breaks.
std::string examplesText(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += fmt::format("{}  {}\n", text.empty() ? "\nExamples:\n" : "", line);
    return text;
}

std::string tableText(const HelpTable& table) {
    std::string text = fmt::format("\n{}:\n", table.title);
    if (!table.about.empty())
        text += paragraph(table.about);
    for (const auto& [name, words] : table.rows)
        text += entry(name, words);
    return text;
}

} // namespace

HelpFormatter::HelpFormatter(HelpSections sections)
    : sections_(std::move(sections)) {
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_usage(const CLI::App* command, std::string name) const {
    if (sections_.usage.empty())
        return CLI::Formatter::make_usage(command, name);
    std::string text;
    for (const std::string& line : sections_.usage)
        text += fmt::format("{} {} [OPTIONS] {}\n", text.empty() ? "Usage:" : "      ", name, line);
    return text;
}

std::string HelpFormatter::make_help(const CLI::App* command, std::string name,
                                     CLI::AppFormatMode mode) const {
    std::vector<std::string> titles = command->get_groups();
    std::ranges::stable_partition(titles, [](const std::string& title) { return title != sharedGroup; });
    std::string text = make_description(command) + make_usage(command, std::move(name)) +
                       examplesText(sections_.examples) + make_positionals(command) +
                       make_subcommands(command, mode);
    for (const std::string& title : titles) {
        const std::vector<const CLI::Option*> options = command->get_options([&](const CLI::Option* option) {
            return option->get_group() == title && option->nonpositional();
        });
        if (!options.empty())
            text += make_group(title, false, options);
    }
    for (const HelpTable& table : sections_.tables)
        text += tableText(table);
    return text + "\n" + make_footer(command);
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool positional) const {
    std::string name = make_option_name(option, positional);
    std::string words = option->get_description();
    const std::string type = option->get_type_name();
    const std::size_t colon = std::min(type.find(':'), type.size());
    if (option->get_type_size() != 0 && !positional)
        name += " " + type.substr(0, colon);
    if (const std::string range = rangeIn(std::string_view(type).substr(colon)); !range.empty())
        words += fmt::format(" From {}.", range);
    if (!option->get_default_str().empty())
        words += fmt::format(" Default: {}.", option->get_default_str());
    if (option->get_required() && !positional)
        words += " Required.";
    if (!option->get_envname().empty())
        words += fmt::format(" The environment variable {} does the same.", option->get_envname());
    return entry(name, words);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
    return entry(command->get_name(), command->get_description(), commandColumn);
}

std::string HelpFormatter::make_description(const CLI::App* command) const {
    return paragraph(command->get_description());
}

std::string HelpFormatter::make_footer(const CLI::App* command) const {
    std::string text;
    std::istringstream lines(command->get_footer());
    for (std::string line; std::getline(lines, line);)
        text += paragraph(line);
    return text;
}

} // namespace texplorer
