#pragma once

// What is wrong with a command line, in the words that all other mistakes are told in.

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace texplorer {

/// "texshot shot": the command that was called, as one would write it.
[[nodiscard]] inline std::string calledCommand(const CLI::App& app) {
    std::string name = app.get_name();
    for (const CLI::App* command : app.get_subcommands())
        name += " " + command->get_name();
    return name;
}

/// One sentence, without the program's name.
[[nodiscard]] inline std::string describeWrongCall(const CLI::App& app, const CLI::ParseError& error) {
    const std::string said = error.what();
    if (const std::vector<std::string> extra = app.remaining(true);
        error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !extra.empty()) {
        const std::string& first = extra.front();
        return (first.starts_with("-") ? "there is no option " + first
                                       : "expected no further argument, found \"" + first + "\"") +
               "; see " + calledCommand(app) + " --help";
    }
    // "--size: 1 required TEXT missing"
    if (const std::size_t colon = said.find(": 1 required ");
        colon != std::string::npos && said.ends_with(" missing"))
        return said.substr(0, colon) + ": expected a value, found none";
    return said;
}

} // namespace texplorer
