#pragma once

#include <map>
#include <string>

namespace texplorer::ui {

/// Where the widgets of the last frame were, by parameter path or by name: how a test finds what it clicks
/// on. A session without a probe records nothing.
struct Probe {
    struct Item {
        float left, top, right, bottom; ///< pixels, origin at the top left
        bool visible;                   ///< not scrolled out of its panel
    };
    std::map<std::string, Item, std::less<>> items;
};

} // namespace texplorer::ui
