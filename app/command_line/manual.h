#pragma once

#include "app/command_line/command_line.h"
#include "core/base/result.h"

#include <string>
#include <vector>

namespace texplorer {

/// The manual pages of a program, without their section: its own and one for each command, "texshot",
/// "texshot-shot", …
[[nodiscard]] std::vector<std::string> manualPages(const CommandLine& line);

/// What stands in the place of a page for their names, one a line.
inline constexpr const char* manualList = "list";

/// One of them in the language of man(7), made of what --help says. Its date is that of SOURCE_DATE_EPOCH,
/// where the environment has it, else today. The error names the pages that there are.
[[nodiscard]] Result<std::string> manualPage(const CommandLine& line, const std::string& page);

} // namespace texplorer
