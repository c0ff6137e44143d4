#pragma once

#include "app/command_line/command_line.h"
#include "texplorer/base/result.h"

#include <string>
#include <vector>

namespace texplorer {

/// The names of a program's manual pages, without their section: the program's own page and one for each
/// command, "texshot", "texshot-shot", …
[[nodiscard]] std::vector<std::string> manualPages(const CommandLine& line);

/// Instead of a page name: prints the names of all pages, one per line.
inline constexpr const char* manualList = "list";

/// A manual page in the language of man(7), made from the text of --help. Its date is SOURCE_DATE_EPOCH if
/// set in the environment, else today. The error lists the available pages.
[[nodiscard]] Result<std::string> manualPage(const CommandLine& line, const std::string& page);

} // namespace texplorer
