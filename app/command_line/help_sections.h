#pragma once

#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// Names with what each means, under a title of their own.
struct HelpTable {
    std::string title;      ///< "Suites"
    std::string about = {}; ///< sentences before the rows
    std::vector<std::pair<std::string, std::string>> rows = {};
};

/// What is said of a command beside its options: in --help and in its manual page.
struct HelpSections {
    std::vector<std::string> usage = {};    ///< how it is called; empty: as its options and arguments say it
    std::vector<std::string> examples = {}; ///< lines of a shell
    std::vector<HelpTable> tables = {};
};

} // namespace texplorer
