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
#include "app/ui/model/sections.h"
#include "app/ui/model/selection.h"
#include "app/ui/model/settings.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/model/view_settings.h"
#include "core/base/result.h"
#include "core/diagnosis/diagnosis.h"
#include "core/emit/flavour.h"
#include "core/mesh/mesh.h"
#include "core/scene/picking.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

struct LessonRun; // see lesson_run.h

struct WantedProbe {
    int x = 0;
    int y = 0;
    std::optional<reference::PixelPlace> pixel{}; ///< which it is in the picture that is shown
};

struct Playback {
    bool playing = true; ///< time goes on while something in the scene depends on it
    double time = 0;     ///< seconds
    float speed = 1;     ///< scene seconds a second
    bool loops = true;   ///< where the last key frame has come, time begins anew
};

/// What is written as a picture.
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

/// What waits until the user has decided about unsaved changes.
enum class Pending { None, NewScene, Example, Lesson, OpenScene, OpenFiles, OpenPicture, ShowScene, Quit };

/// The visible part of the texture plane.
struct Plane {
    float s = 0.5F; ///< the coordinates at the centre of the panel
    float t = 0.5F;
    float extent = 1.6F; ///< how much of the plane the panel's shorter side shows
};

/// Dialog::Picture: an image that holds a scene, which the user may have meant.
struct AskedPicture {
    std::filesystem::path file;
    bool begins = false; ///< the command line names it: to begin with it is no edit
};

/// A sentence for the user, in the status bar until it is dismissed.
struct Notice {
    std::string text;           ///< empty: nothing to say
    std::filesystem::path file; ///< one that it may help to look into; empty: none
    bool isGood = false;        ///< something was done; else it says what went wrong
};

/// How one looks at the document that there is: another one is looked at anew.
struct DocumentLook {
    Playback playback;
    Selection selection;
    std::optional<PickedVertex> hoveredInView;  ///< the vertex that the pointer is on, kept by the view
    std::optional<PickedVertex> hoveredInPlane; ///< the same of the texture space
    Plane plane;
    std::string shownParam;         ///< the parameter that was scrolled to, framed until the next click
    std::optional<Preview> preview; ///< the view shows it: see preview.h
    /// A pixel that is explained, in thousandths from the upper left, until the user chooses another one.
    std::optional<WantedProbe> wantedProbe;
    Explaining explaining;
    LevelView levels;
    InspectedFile fileView;
    Notice notice;
    std::optional<Fix> wantedFix; ///< is applied at the end of the frame, when nobody walks the scene
};

/// What a lesson's step shows, and what it took the place of.
struct LessonPictures {
    ShownPictures before{};
    ShownPictures chosen{};
};

/// How one looks at whatever document there is, and what panels say to each other, as plain values. What one
/// panel alone remembers is beside that panel.
struct WindowState : DocumentLook {
    Settings settings;                           ///< what outlives the window
    Language systemLanguage = Language::English; ///< what "like the system" is
    ViewSettings view; ///< which renderers draw the scene, and how one looks at their frames
    std::optional<LessonPictures> lessonPictures;
    bool showsFrameTime = true; ///< off where two pictures of the window should be the same
    bool movesVertices = false; ///< in texture space, just now: what would be an edit of its own waits
    bool keyTaken = false;      ///< a panel did something with a key of this frame: it is no shortcut as well
    bool showRq = false;        ///< whether the vertex list shows r and q

    std::optional<Tab> wantedTab; ///< is opened where it lies and comes to the front with the next frame
    std::string wantedParam;      ///< the parameters are scrolled there with the next frame; empty: not
    std::optional<Section> wantedSection; ///< is opened and scrolled to with the next frame
    std::string
        hoveredParam; ///< under the pointer in the last frame, in whichever panel: all panels light it
    std::string hoveringParam; ///< the same of this frame, said by the panel that draws it

    Dialog dialog = Dialog::None;
    emit::Flavour flavour = emit::Flavour::Fixed; ///< of Dialog::SaveProgram
    bool allCalls = false;  ///< programs set what OpenGL has anyway, too: as listed, copied and exported
    std::string imageParam; ///< OpenImage: what shall name it; empty: the texture that is bound
    Pending pending = Pending::None;
    std::vector<std::filesystem::path> pendingFiles;
    AskedPicture askedPicture;
    std::string pendingExample;       ///< its file's name
    std::string pendingLesson;        ///< its name, or its folder
    std::shared_ptr<Load> readyScene; ///< loaded, and waits for an answer about unsaved changes
    std::vector<Error> refused; ///< of several files: those that could not be opened, until one has read it
    bool quitConfirmed = false;
    bool fillsScreen = false;             ///< the host shows the window without a frame, over everything
    std::optional<int> tour;              ///< the step of the tour that is shown, from 0
    std::optional<Capture> wantedCapture; ///< is read back and written with the next frame

    bool wantsSearch = false; ///< the keyboard goes to the search among the parameters with the next frame

    int textureUnits = maxUnits;          ///< that the driver has, as far as is known
    std::shared_ptr<LessonRun> lesson;    ///< nullptr: none is open
    Figure figure = Figure::Environments; ///< of the tab of figures
    SheetChoice sheet;
    RecordingChoice recording;
    ViewNotes notes;
    bool spotlight = false; ///< all but a disc around the pointer is dim

    std::shared_ptr<const Mesh> mesh; ///< of the selected model, kept by `selectedMesh`
    ShapeOptions meshShape{};         ///< what it was made from
    MeshData meshData{};
};

} // namespace texplorer::ui
