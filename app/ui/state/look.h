#pragma once

#include "app/ui/state/inspected_file.h"
#include "app/ui/state/notes.h"
#include "app/ui/state/selection.h"
#include "texplorer/image/image.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/reference/level_map_worker.h"
#include "texplorer/reference/probe_worker.h"
#include "texplorer/scene/picking.h"
#include "texplorer/scene/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

/// A pixel to explain, in pictures of any size.
struct WantedProbe {
    std::function<reference::PixelPlace(lesson::PictureSize, double zoom)> in;
    std::optional<reference::PixelPlace> pixel{}; ///< in the shown picture
    double zoom = 1;                              ///< of a fitted camera that moved, at this pixel
    double distance = 0; ///< of what the pixel shows from the eye's plane; 0: not known yet
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
    Sentence text;              ///< empty: no message
    std::filesystem::path file; ///< a file related to it; empty: none
    bool isGood = false;        ///< reports success; else a problem
};

/// The user's questions about the picture: why a pixel has its colour, and which pixels a texel contributes
/// to.
struct Explaining {
    std::optional<reference::PixelPlace> pixel{};
    std::optional<reference::TexelQuestion> texel{};
    std::shared_ptr<const TextureImage> texelOf{}; ///< the image of the texel: cleared together with it
    std::shared_ptr<const reference::ProbeWorker::Answer>
        answer{};                         ///< the newest answer; may be for an earlier question
    std::shared_ptr<const Image> light{}; ///< from the answer: alpha is the texel's weight in each pixel
    std::shared_ptr<const reference::ProbeWorker::Answer> lightOf{};
    /// The answer for a pinned pixel, shown next to the current one, as it was when it was pinned; nullptr:
    /// none.
    std::shared_ptr<const reference::ProbeWorker::Answer> pinned{};
    bool isOpen = false; ///< the tab is in front: a click in the view selects the pixel
};

/// The levels that each pixel reads: shown as false colours over the pictures, and in the tab Levels.
struct LevelView {
    std::optional<reference::PixelPlace> hovered{}; ///< the pixel under the pointer, set by the view
    std::shared_ptr<const reference::LevelMapWorker::Answer>
        answer{}; ///< the newest; may be for an earlier question
};

/// The scene that the view shows instead of the document's while the pointer rests on a choice. It is not
/// recorded, diagnosed or saved.
struct Preview {
    std::string choice{};                 ///< identifies it: "textures[0].wrapS=GL_CLAMP"
    Sentence text{};                      ///< the text in the view: "Wrap s: Clamp (legacy)"
    std::shared_ptr<const Scene> scene{}; ///< nullptr: not shown, see restPreview
    Scene madeOf{};                       ///< the document's scene without the edit
    bool wanted = false;                  ///< requested in this frame
};

/// How the current document is shown; reset for another document.
struct Look {
    Playback playback;
    Selection selection;
    std::optional<PickedVertex> hoveredInView;  ///< the vertex under the pointer, set by the view
    std::optional<PickedVertex> hoveredInPlane; ///< the same in the texture space
    Plane plane;
    std::string shownParam;         ///< the parameter that was scrolled to; has a frame until the next click
    std::optional<Preview> preview; ///< shown by the view
    std::optional<WantedProbe> wantedProbe; ///< a lesson's mark, or the pixel that the user has selected
    ViewNotes notes;
    Explaining explaining;
    LevelView levels;
    InspectedFile fileView;
    Notice notice;
};

} // namespace texplorer::ui
