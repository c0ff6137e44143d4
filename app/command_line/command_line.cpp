#include "app/command_line/command_line.h"

#include "app/command_line/help_format.h"

#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <sstream>

namespace texplorer {
namespace {

std::shared_ptr<CLI::App> makeApp(const std::string& program, const std::string& version,
                                  const std::string& help) {
    auto app = std::make_shared<CLI::App>(help, program);
    app->formatter(std::make_shared<HelpFormatter>());
    app->set_version_flag("--version", fmt::format("{} {}", program, version));
    return app;
}

/// One sentence, without the program's name.
std::string sentenceFor(const CLI::App& app, const std::string& called, const CLI::ParseError& error) {
    std::string said = error.what();
    if (const std::vector<std::string> extra = app.remaining(true);
        error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !extra.empty()) {
        const std::string& first = extra.front();
        return fmt::format("{}; see {} --help",
                           first.starts_with("-")
                               ? "there is no option " + first
                               : fmt::format("expected no further argument, found \"{}\"", first),
                           called);
    }
    // "--size: 1 required TEXT missing"
    if (const std::size_t colon = said.find(": 1 required ");
        colon != std::string::npos && said.ends_with(" missing"))
        return said.substr(0, colon) + ": expected a value, found none";
    return said;
}

} // namespace

std::string Option::name() const {
    return option_->get_name();
}

bool Option::isGiven() const {
    if (option_->count() == 0)
        return false;
    const char* environment =
        option_->get_envname().empty() ? nullptr : std::getenv(option_->get_envname().c_str()); // NOLINT
    return environment == nullptr || option_->results().front() != environment;
}

Command::Command(std::shared_ptr<CLI::App> app)
    : app_(std::move(app)) {}

std::string Command::name() const {
    return app_->get_name();
}

const Option& Command::keep(CLI::Option& option, const OptionRules& rules) {
    if (!rules.value.empty())
        option.type_name(rules.value);
    if (!rules.environment.empty())
        option.envname(rules.environment);
    if (rules.required)
        option.required();
    if (rules.showsDefault)
        option.capture_default_str();
    if (rules.oneEach)
        option.allow_extra_args(false);
    if (rules.needs != nullptr)
        option.needs(rules.needs->option_);
    if (rules.excludes != nullptr)
        option.excludes(rules.excludes->option_);
    if (rules.check)
        option.check(rules.check);
    return options_.emplace_back(option);
}

const Option& Command::option(const std::string& names, std::string& value, const std::string& help,
                              const OptionRules& rules) {
    return keep(*app_->add_option(names, value, help), rules);
}

const Option& Command::option(const std::string& names, std::vector<std::string>& values,
                              const std::string& help, const OptionRules& rules) {
    return keep(*app_->add_option(names, values, help), rules);
}

const Option& Command::flag(const std::string& names, bool& value, const std::string& help,
                            const OptionRules& rules) {
    return keep(*app_->add_flag(names, value, help), rules);
}

const Option& Command::numberOption(const std::string& names, const std::function<void(long long)>& store,
                                    const std::string& start, long long low, long long high,
                                    const std::string& help, const OptionRules& rules) {
    const std::string range = fmt::format("{} to {}", low, high);
    const auto parse = [store, names, low, high, range](const std::string& text) {
        long long number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || stop != text.data() + text.size() || number < low || number > high)
            throw CLI::ValidationError(
                names, fmt::format("expected a whole number from {}, found \"{}\"", range, text));
        store(number);
    };
    CLI::Option* option =
        app_->add_option_function<std::string>(names, parse, fmt::format("{} From {}.", help, range))
            ->type_name("NUMBER");
    keep(*option, rules);
    if (rules.showsDefault)
        option->default_str(start);
    return options_.back();
}

void Command::footer(const std::string& text) {
    app_->footer(text);
}

Command& Command::command(const std::string& name, const std::string& help) {
    app_->require_subcommand(1);
    std::shared_ptr<CLI::App> app(app_, app_->add_subcommand(name, help));
    return *commands_.emplace_back(new Command(std::move(app)));
}

void Command::onCall(std::function<int()> action) {
    action_ = std::move(action);
}

int Command::run() const {
    for (const auto& command : commands_) {
        if (command->app_->parsed())
            return command->run();
    }
    return action_();
}

CommandLine::CommandLine(const std::string& program, const std::string& version, const std::string& help)
    : Command(makeApp(program, version, help)) {}

/// "texshot shot": the command that was called, as one would write it.
std::string CommandLine::calledCommand() const {
    std::string name = app_->get_name();
    for (const CLI::App* command : app_->get_subcommands())
        name += " " + command->get_name();
    return name;
}

/// CLI11 would say only that a subcommand is missing. Empty: none is.
std::string CommandLine::missingCommand(int argc, const char* const* argv) const {
    if (commands_.empty() || (argc > 1 && app_->get_option_no_throw(argv[1]) != nullptr))
        return {};
    std::string names;
    for (const auto& command : commands_) {
        if (argc > 1 && command->name() == argv[1])
            return {};
        names.append(names.empty() ? "" : ", ").append(command->name());
    }
    return fmt::format("{}; expected one of {}",
                       argc > 1 ? fmt::format("there is no command \"{}\"", argv[1]) : "a command is missing",
                       names);
}

Result<std::optional<std::string>> CommandLine::parse(int argc, const char* const* argv) {
    if (const std::string missing = missingCommand(argc, argv); !missing.empty())
        return fail(ErrorCode::OutOfRange, missing);
    try {
        app_->parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0)
            return fail(ErrorCode::OutOfRange, sentenceFor(*app_, calledCommand(), error));
        std::ostringstream text; // --help, --version
        app_->exit(error, text);
        return text.str();
    }
}

} // namespace texplorer
