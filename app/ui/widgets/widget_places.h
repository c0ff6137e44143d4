#pragma once

#include <imgui.h>

#include <map>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// While one of these lives, widgets report to it where they are, by parameter path or by name: how a test
/// finds what it clicks on. At most one at a time, on the thread that draws.
class WidgetPlaces {
public:
    struct Item {
        float left, top, right, bottom; ///< pixels, origin at the top left
        bool visible;                   ///< not scrolled out of its panel
    };

    WidgetPlaces();
    WidgetPlaces(const WidgetPlaces&) = delete;
    WidgetPlaces& operator=(const WidgetPlaces&) = delete;
    ~WidgetPlaces();

    std::map<std::string, Item, std::less<>> items; ///< of the last frame
};

/// Whether anybody is told: what costs much to report needn't be where not.
[[nodiscard]] bool arePlacesWanted();

/// What was reported of the frame before is forgotten.
void forgetPlaces();

/// Reports where the last widget is.
void noteItem(std::string_view name);

/// Reports something that is drawn but no widget; a point has two equal corners.
void noteDrawn(std::string_view name, ImVec2 upperLeft, ImVec2 lowerRight);

} // namespace texplorer::ui
