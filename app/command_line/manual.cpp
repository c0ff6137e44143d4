#include "app/command_line/manual.h"

#include "app/command_line/choice_argument.h"
#include "texplorer/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <string_view>

namespace texplorer {
namespace {

/// The programs that refer to each other in their manuals.
constexpr std::array<std::string_view, 2> programs{"texplorer", "texshot"};

/// One line of text without macros and escapes of roff. Letters beyond ASCII are written by their groff names
/// because groff does not read UTF-8 by itself; long words get places to break.
std::string roffText(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (const Utf8Character letter = firstCharacter(text.substr(i)); letter.bytes > 1) {
            out += fmt::format("\\[u{:04X}]", static_cast<unsigned>(letter.character));
            i += letter.bytes - 1;
        } else if (c == ',' && i + 1 < text.size() && text[i + 1] != ' ') {
            out += ",\\:";
        } else if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\n')
            out += ' ';
        else if (c == '~' || c == '^') // keyboard characters, not accents
            out += c == '~' ? "\\(ti" : "\\(ha";
        else
            out += c;
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// One sentence per line, as roff expects.
std::string roffSentences(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = text.find(". ");
        out += roffText(text.substr(0, end == std::string_view::npos ? end : end + 1)) + "\n";
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    }
    return out;
}

/// A line of a shell: plain ASCII that can be copied from the page.
std::string roffLiteral(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '\\':
            out += "\\e";
            break;
        case '-':
            out += "\\-";
            break;
        case '\'':
            out += "\\(aq";
            break;
        case '`':
            out += "\\(ga";
            break;
        case '~':
            out += "\\(ti";
            break;
        case '^':
            out += "\\(ha";
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string inCapitals(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return text;
}

std::string bold(std::string_view text) {
    return "\\fB" + roffText(text) + "\\fR";
}

std::string italic(std::string_view text) {
    return "\\fI" + roffText(text) + "\\fR";
}

/// The date of the page: 2026-11-23.
std::string dateOfPage() {
    std::time_t seconds = std::time(nullptr);
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) { // NOLINT(concurrency-mt-unsafe)
        const std::string_view text(epoch);
        long long number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc() && stop == text.data() + text.size())
            seconds = static_cast<std::time_t>(number);
    }
    std::tm day = {};
    if (::gmtime_r(&seconds, &day) == nullptr)
        return "1970-01-01";
    return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

std::string firstSentence(std::string_view help) {
    std::string text(help.substr(0, help.find(". ")));
    while (text.ends_with('.'))
        text.pop_back();
    return text;
}

std::string synopsisOf(const Command& command, const std::string& called, bool hasCommands) {
    const std::string name = ".B " + roffText(called) + "\n";
    if (hasCommands)
        return name + italic("COMMAND") + " [" + italic("OPTIONS") + "]\n";
    if (!command.usage().empty()) {
        std::string text;
        for (const std::string& line : command.usage())
            text += fmt::format("{}{}[{}] {}\n", text.empty() ? "" : ".br\n", name, italic("OPTIONS"),
                                roffText(line));
        return text;
    }
    std::string text = name + "[" + italic("OPTIONS") + "]";
    for (const Option& option : command.options()) {
        if (!option.isArgument())
            continue;
        const std::string word = italic(option.names().front()) + (option.isList() ? "..." : "");
        text += option.rules().required ? " " + word : " [" + word + "]";
    }
    return text + "\n";
}

std::string optionOf(const Option& option) {
    const OptionRules& rules = option.rules();
    std::string names;
    for (const std::string& name : option.names())
        names += (names.empty() ? "" : ", ") + (option.isArgument() ? italic(name) : bold(name));
    if (!option.isFlag() && !option.isArgument())
        names += " " + italic(rules.value.empty() ? "NUMBER" : rules.value);
    std::string help = option.help();
    if (!option.initial().empty())
        help += fmt::format(" Default: {}.", option.initial());
    if (rules.required && !option.isArgument())
        help += " Required.";
    if (!rules.environment.empty())
        help += fmt::format(" The environment variable {} does the same.", rules.environment);
    return ".TP\n" + names + "\n" + roffSentences(help);
}

std::string optionsOf(const Command& command) {
    std::string arguments;
    std::string options;
    for (const Option& option : command.options())
        (option.isArgument() ? arguments : options) += optionOf(option);
    for (const Option& option : command.sharedOptions())
        options += optionOf(option);
    return (arguments.empty() ? "" : ".SH ARGUMENTS\n" + arguments) + ".SH OPTIONS\n" + options;
}

std::string commandsOf(const CommandLine& line) {
    std::string text;
    std::string group;
    for (const auto& command : line.commands()) {
        if (command->group() != group && !command->group().empty())
            text += ".SS " + roffText(command->group()) + "\n";
        group = command->group();
        text += ".TP\n" + bold(command->name()) + "\n" + roffSentences(command->help());
    }
    return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

/// Verbatim: lines of a shell must not be broken.
std::string examplesOf(const Command& command) {
    std::string text;
    for (const std::string& line : command.examples())
        text += roffLiteral(line) + "\n";
    return text.empty() ? "" : fmt::format(".SH EXAMPLES\n.RS\n.nf\n{}.fi\n.RE\n", text);
}

std::string tablesOf(const Command& command) {
    std::string text;
    for (const HelpTable& table : command.tables()) {
        text += ".SH " + roffText(inCapitals(table.title)) + "\n" + roffSentences(table.about);
        for (const auto& [name, words] : table.rows)
            text += ".TP\n" + bold(name) + "\n" + roffSentences(words);
    }
    return text;
}

/// The lines of a footer, without the exit status, which has its own section.
std::string footerOf(const Command& command) {
    constexpr std::string_view exits = "Exit status: ";
    std::string notes;
    std::string status;
    std::istringstream lines(command.footer());
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(exits))
            status = roffSentences(line.substr(exits.size()));
        else if (!line.empty())
            notes += (notes.empty() ? "" : ".PP\n") + roffSentences(line);
    }
    return (notes.empty() ? "" : ".SH NOTES\n" + notes) +
           (status.empty() ? "" : ".SH EXIT STATUS\n" + status);
}

std::string seeAlso(const CommandLine& line, const std::string& page) {
    std::vector<std::string> pages = manualPages(line);
    for (const std::string_view program : programs)
        if (program != line.name())
            pages.emplace_back(program);
    std::string text;
    for (const std::string& each : pages)
        if (each != page)
            text += fmt::format("{}.BR {} (1)", text.empty() ? "" : ",\n", roffText(each));
    return ".SH SEE ALSO\n" + text + "\n";
}

} // namespace

std::vector<std::string> manualPages(const CommandLine& line) {
    std::vector<std::string> pages{line.name()};
    for (const auto& command : line.commands())
        pages.push_back(line.name() + "-" + command->name());
    return pages;
}

Result<std::string> manualPage(const CommandLine& line, const std::string& page) {
    if (page == manualList)
        return fmt::format("{}\n", fmt::join(manualPages(line), "\n"));
    const Command* shown = page == line.name() ? &line : nullptr;
    for (const auto& command : line.commands())
        if (page == line.name() + "-" + command->name())
            shown = command.get();
    if (shown == nullptr)
        return refuseChoice(manualPages(line), page, manualOption);
    const bool isProgram = shown == &line;
    const std::string called = isProgram ? line.name() : line.name() + " " + shown->name();
    return fmt::format(".TH {} 1 {} \"{}\" \"User Commands\"\n.ad l\n", roffText(inCapitals(page)),
                       dateOfPage(), roffText(line.version())) +
           fmt::format(".SH NAME\n{} \\- {}\n", roffText(page), roffText(firstSentence(shown->help()))) +
           ".SH SYNOPSIS\n" + synopsisOf(*shown, called, isProgram && !line.commands().empty()) +
           ".SH DESCRIPTION\n" + roffSentences(shown->help()) + (isProgram ? commandsOf(line) : "") +
           optionsOf(*shown) + tablesOf(*shown) + footerOf(*shown) + examplesOf(*shown) + seeAlso(line, page);
}

} // namespace texplorer
