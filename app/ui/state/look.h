#pragma once

#include "app/ui/state/explaining.h"
#include "app/ui/state/inspected_file.h"
#include "app/ui/state/level_view.h"
#include "app/ui/state/preview.h"
#include "app/ui/state/selection.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/scene/picking.h"

#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

struct WantedProbe {
    int x = 0;
    int y = 0;
    std::optional<reference::PixelPlace> pixel{}; ///< in the shown picture
};

struct Playback {
    bool playing = true; ///< the clock runs if something in the scene depends on it
    double time = 0;     ///< seconds
    float speed = 1;     ///< scene seconds per second
    bool loops = true;   ///< the clock restarts after the last key frame
};

/// The visible part of the texture plane.
struct Plane {
    float s = 0.5F; ///< the coordinates in the middle of the panel
    float t = 0.5F;
    float extent = 1.6F; ///< the part of the plane along the panel's shorter side
};

/// A message in the status bar until it is dismissed.
struct Notice {
    std::string text;           ///< empty: no message
    std::filesystem::path file; ///< a file related to it; empty: none
    bool isGood = false;        ///< reports success; else a problem
};

/// How the current document is shown; reset for another document.
struct Look {
    Playback playback;
    Selection selection;
    std::optional<PickedVertex> hoveredInView;  ///< the vertex under the pointer, set by the view
    std::optional<PickedVertex> hoveredInPlane; ///< the same in the texture space
    Plane plane;
    std::string shownParam;         ///< the parameter that was scrolled to; has a frame until the next click
    std::optional<Preview> preview; ///< shown by the view: see preview.h
    /// A pixel to explain, in thousandths from the upper left, until the user selects another one.
    std::optional<WantedProbe> wantedProbe;
    Explaining explaining;
    LevelView levels;
    InspectedFile fileView;
    Notice notice;
};

} // namespace texplorer::ui
