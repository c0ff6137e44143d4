#pragma once

#include "app/ui/model/details_tabs.h"
#include "app/ui/model/explaining.h"
#include "app/ui/model/figures.h"
#include "app/ui/model/inspected_file.h"
#include "app/ui/model/layout.h"
#include "app/ui/model/level_view.h"
#include "app/ui/model/load.h"
#include "app/ui/model/notes.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/recording_file.h"
#include "app/ui/model/selection.h"
#include "app/ui/model/settings.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/model/view_settings.h"
#include "core/base/result.h"
#include "core/emit/flavour.h"
#include "core/scene/picking.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace texplorer::ui {

struct LessonRun; // see lesson_run.h

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

/// What to write as a picture.
enum class Capture { View, Window };

enum class Dialog {
    None,
    OpenScene,
    OpenImage,
    SaveScene,
    SaveAnswers,
    SaveSheet,
    SaveProgram,
    Record,
    SaveRecording,
    Discard,
    FileHasChanged, ///< see Document::changedFile
    Help,
    Restore,
    Refused,
    Picture
};

/// What waits for the answer about unsaved changes.
namespace pending {
struct NewScene {};
struct Example {
    std::string file; ///< its name
};
struct Lesson {
    std::string nameOrFolder;
};
struct ChooseScene {};
struct OpenFiles {
    std::vector<std::filesystem::path> files; ///< at least one
};
struct OpenScene {
    std::filesystem::path file;
};
struct ShowScene {
    std::shared_ptr<Load> load; ///< finished; shared for the sake of copies of the state
};
struct Quit {};
} // namespace pending

/// The action that waits for the user's decision about unsaved changes.
using Pending =
    std::variant<std::monostate, pending::NewScene, pending::Example, pending::Lesson, pending::ChooseScene,
                 pending::OpenFiles, pending::OpenScene, pending::ShowScene, pending::Quit>;

/// The visible part of the texture plane.
struct Plane {
    float s = 0.5F; ///< the coordinates in the middle of the panel
    float t = 0.5F;
    float extent = 1.6F; ///< the part of the plane along the panel's shorter side
};

/// For Dialog::Picture: an image that contains a scene, which the user may want to open.
struct AskedPicture {
    std::filesystem::path file;
    bool begins = false; ///< named on the command line: opening it first is not an edit
};

/// A message in the status bar until it is dismissed.
struct Notice {
    std::string text;           ///< empty: no message
    std::filesystem::path file; ///< a file related to it; empty: none
    bool isGood = false;        ///< reports success; else a problem
};

/// How the current document is shown; reset for another document.
struct DocumentLook {
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

/// The pictures of a lesson's step, and the settings that they replaced.
struct LessonPictures {
    ShownPictures before{};
    ShownPictures chosen{};
};

/// How any document is shown, and plain values that panels exchange. The state of a single panel is in its
/// own struct.
struct WindowState : DocumentLook {
    Settings settings;                           ///< kept between windows
    Language systemLanguage = Language::English; ///< the language of the system
    ViewSettings view;                           ///< the renderers and how their frames are shown
    std::optional<LessonPictures> lessonPictures;
    bool showsFrameTime = true; ///< false for reproducible pictures of the window
    bool showRq = false;        ///< whether the vertex list shows r and q

    std::optional<Tab> wantedTab; ///< opened and brought to the front in the next frame
    std::string hoveredParam; ///< under the pointer in the last frame, in any panel: all panels highlight it

    Dialog dialog = Dialog::None;
    emit::Flavour flavour = emit::Flavour::Fixed; ///< for Dialog::SaveProgram
    bool allCalls = false;  ///< programs also set OpenGL's initial values: when listed, copied and exported
    std::string imageParam; ///< for OpenImage: the parameter that will name it; empty: the bound texture
    Pending pending{};
    AskedPicture askedPicture;
    std::vector<Error> refused; ///< files that could not be opened, until the user has read the list
    bool quitConfirmed = false;
    bool fillsScreen = false;             ///< the host shows the window in full screen
    std::optional<int> tour;              ///< the current step of the tour, from 0
    std::optional<Capture> wantedCapture; ///< read back and written in the next frame

    int textureUnits = maxUnits;          ///< of the driver, as far as known
    std::shared_ptr<LessonRun> lesson;    ///< nullptr: none is open
    Figure figure = Figure::Environments; ///< in the tab of figures
    SheetChoice sheet;
    RecordingChoice recording;
    ViewNotes notes;
    bool spotlight = false; ///< everything except a disc around the pointer is dimmed
};

} // namespace texplorer::ui
