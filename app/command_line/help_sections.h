#pragma once

#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// A table of names and their meanings, with a title.
struct HelpTable {
    std::string title;      ///< "Suites"
    std::string about = {}; ///< sentences before the rows
    std::vector<std::pair<std::string, std::string>> rows = {};
};

/// Further sections of a command in --help and in its manual page.
struct HelpSections {
    std::vector<std::string> usage = {};    ///< the usage lines; empty: made from its options and arguments
    std::vector<std::string> examples = {}; ///< lines of a shell
    std::vector<HelpTable> tables = {};
};

} // namespace texplorer
