#pragma once

#include <string>
#include <vector>

namespace texplorer::test {

/// The texts of the last frame as they are drawn, read from the letters' places in the font atlas: a line or
/// its visible part each. Without those in the font of code.
[[nodiscard]] std::vector<std::string> drawnTexts();

} // namespace texplorer::test
