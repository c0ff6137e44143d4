#pragma once

#include "app/ui/language/language.h"
#include "app/ui/state/details_tabs.h"
#include "app/ui/state/figures.h"
#include "texplorer/scene/scene.h"

#include <optional>
#include <string>

namespace texplorer::ui {

/// What to write as a picture.
enum class Capture { View, Window };

/// The rest of the window's state: plain values that panels exchange. The state of a single panel is in its
/// own struct.
struct WindowState {
    Language systemLanguage = Language::English; ///< the language of the system
    std::string page; ///< the address of the page that shows the window, without #; empty: there is none
    bool showsFrameTime = true; ///< false for reproducible pictures of the window
    bool showRq = false;        ///< whether the vertex list shows r and q
    bool allCalls = false;    ///< programs also set OpenGL's initial values: when listed, copied and exported
    bool fillsScreen = false; ///< the host shows the window in full screen
    bool spotlight = false;   ///< everything except a disc around the pointer is dimmed
    int textureUnits = maxUnits;          ///< of the driver, as far as known
    Figure figure = Figure::Environments; ///< in the tab of figures
    std::optional<Tab> wantedTab;         ///< opened and brought to the front in the next frame
    bool stepWants = false;               ///< a lesson's step wants it, or a parameter
    std::optional<Capture> wantedCapture; ///< written in the next frame whose view is complete
    std::optional<int> tour;              ///< the current step of the tour, from 0
    std::string hoveredParam; ///< under the pointer in the last frame, in any panel: all panels highlight it
};

} // namespace texplorer::ui
