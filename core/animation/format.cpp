#include "texplorer/animation/format.h"

#include <algorithm>

namespace texplorer::animation {

const FormatRow* formatOfName(std::string_view name) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    for (const FormatRow& row : formatRows) {
        if (name.size() > row.extension.size() &&
            std::ranges::equal(name.substr(name.size() - row.extension.size()), row.extension, {}, lower))
            return &row;
    }
    return nullptr;
}

} // namespace texplorer::animation
