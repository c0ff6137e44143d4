#pragma once

#include <string_view>
#include <vector>

namespace texplorer::screenshot {

/// A file of assets/handout, compiled in.
struct StyleFile {
    std::string_view name;
    std::string_view text;
};

/// How the page of lessons looks, on screens and on paper.
[[nodiscard]] const std::vector<StyleFile>& handoutStyle();

} // namespace texplorer::screenshot
