#pragma once

#include <string_view>
#include <vector>

namespace texplorer::report {

/// A file of assets/report, embedded in the program: "index.html".
struct Asset {
    std::string_view name;
    std::string_view text;
};
[[nodiscard]] const std::vector<Asset>& pageAssets();

} // namespace texplorer::report
