#pragma once

// A program's command line: what it takes is declared, then parsed. Its --help and the sentences about wrong
// calls are the same in every program.

#include "core/base/result.h"

#include <concepts>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI { // CLI11, which command_line.cpp and help_format.cpp alone include: it takes seconds to
                // compile
class App;
class Option;
} // namespace CLI

namespace texplorer {

/// An option, flag or positional argument. Its command keeps it.
class Option {
public:
    explicit Option(CLI::Option& option)
        : option_(&option) {}

    /// "--out" of "-o,--out".
    [[nodiscard]] std::string name() const;

    /// Whether the command line itself has it: what an environment variable says may go unused.
    [[nodiscard]] bool isGiven() const;

private:
    friend class Command;
    CLI::Option* option_;
};

/// What may be said about an option beside its names.
struct OptionRules {
    std::string value = {};       ///< what help calls its value: "FILE"
    std::string environment = {}; ///< the variable that does the same
    bool required = false;
    bool showsDefault = false; ///< help says the value that it has when it is declared
    bool oneEach = false;      ///< of a list: takes one value each time that it is given, not all that follow
    const Option* needs = nullptr;    ///< without which it is refused
    const Option* excludes = nullptr; ///< with which it is refused
    std::function<std::string(const std::string&)> check =
        {}; ///< of a value: what is wrong with it; empty: nothing
};

/// What a program takes, or one of its commands ("texshot shot"). Values are filled in while the line is
/// parsed; they must live until then, and keep what they have where the line doesn't say otherwise.
class Command {
public:
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
    ~Command() = default;

    [[nodiscard]] std::string name() const;

    /// `names`: "--size", "-o,--out", or "FILE" for an argument that has no dashes.
    const Option& option(const std::string& names, std::string& value, const std::string& help,
                         const OptionRules& rules = {});

    /// May be given again: each value joins the others.
    const Option& option(const std::string& names, std::vector<std::string>& values, const std::string& help,
                         const OptionRules& rules = {});

    const Option& flag(const std::string& names, bool& value, const std::string& help,
                       const OptionRules& rules = {});

    /// A whole number from `low` to `high`, which help says.
    template<std::integral T>
    const Option& number(const std::string& names, T& value, long long low, long long high,
                         const std::string& help, const OptionRules& rules = {}) {
        return numberOption(
            names, [&value](long long number) { value = static_cast<T>(number); }, std::to_string(value), low,
            high, help, rules);
    }

    /// The paragraphs below the options in --help, one a line.
    void footer(const std::string& text);

    /// A command of this one, which from then on needs one of them.
    Command& command(const std::string& name, const std::string& help);

    /// What the command does, and the program's exit status.
    void onCall(std::function<int()> action);

    /// Does that, or what the command below it does that was called. After a parse that gave nothing to
    /// print.
    [[nodiscard]] int run() const;

    /// All that were declared so far.
    [[nodiscard]] const std::deque<Option>& options() const { return options_; }

protected:
    explicit Command(std::shared_ptr<CLI::App> app);

    std::shared_ptr<CLI::App> app_; ///< the program's own owns those of its commands
    std::vector<std::unique_ptr<Command>> commands_;

private:
    const Option& keep(CLI::Option& option, const OptionRules& rules);
    const Option& numberOption(const std::string& names, const std::function<void(long long)>& store,
                               const std::string& start, long long low, long long high,
                               const std::string& help, const OptionRules& rules);

    std::deque<Option> options_;
    std::function<int()> action_;
};

/// A program's.
class CommandLine : public Command {
public:
    CommandLine(const std::string& program, const std::string& version, const std::string& help);

    /// Fills in the values. Gives what --help or --version asks for, if one of them is there: nothing else is
    /// to be done then. A wrong call is one sentence, without the program's name.
    [[nodiscard]] Result<std::optional<std::string>> parse(int argc, const char* const* argv);

private:
    [[nodiscard]] std::string calledCommand() const;
    [[nodiscard]] std::string missingCommand(int argc, const char* const* argv) const;
};

} // namespace texplorer
