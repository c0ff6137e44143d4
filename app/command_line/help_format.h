#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace texplorer {

/// --help as we want it: values by their names, sentences in lines of 80 columns, and what is needed or taken
/// otherwise at their end.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option(const CLI::Option* option, bool positional) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_description(const CLI::App* command) const override;
    std::string make_footer(const CLI::App* command) const override; ///< a paragraph for each of its lines
};

} // namespace texplorer
