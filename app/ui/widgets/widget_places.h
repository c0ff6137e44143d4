#pragma once

#include <imgui.h>

#include <map>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// While an object of this class exists, widgets report their positions to it, by parameter path or by name,
/// for tests to click on. At most one at a time, on the thread that draws.
class WidgetPlaces {
public:
    struct Item {
        float left, top, right, bottom; ///< pixels, origin at the top left
        bool visible;                   ///< not scrolled out of its panel
        bool reacts;                    ///< to the pointer
    };

    WidgetPlaces();
    WidgetPlaces(const WidgetPlaces&) = delete;
    WidgetPlaces& operator=(const WidgetPlaces&) = delete;
    ~WidgetPlaces();

    std::map<std::string, Item, std::less<>> items; ///< of the last frame
};

/// Whether there is such an object: if not, expensive reports can be skipped.
[[nodiscard]] bool arePlacesWanted();

/// Removes the reports of the previous frame.
void forgetPlaces();

/// Reports the position of the last widget.
void noteItem(std::string_view name);

/// Reports something drawn that is not a widget; a point has two equal corners.
void noteDrawn(std::string_view name, ImVec2 upperLeft, ImVec2 lowerRight);

} // namespace texplorer::ui
