#pragma once

#include "app/ui/model/background.h"
#include "app/ui/model/details_tabs.h"
#include "app/ui/model/explaining.h"
#include "app/ui/window/file_browser.h"
#include "app/ui/model/file_view.h"
#include "app/ui/model/glsl_view.h"
#include "app/ui/window/layout.h"
#include "app/ui/model/loads.h"
#include "app/ui/widgets/probe.h"
#include "app/ui/model/sections.h"
#include "app/ui/model/unsaved_work.h"
#include "app/ui/model/views.h"
#include "core/base/result.h"
#include "core/diagnosis/diagnosis.h"
#include "core/scene/history.h"
#include "core/texture/image_source.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texplorer::ui {

struct Playback {
    bool playing = true; ///< time goes on while something in the scene depends on it
    double time = 0;     ///< seconds
    float speed = 1;     ///< scene seconds a second
};

/// What the panels show. Indices beyond the scene are brought back by `settle`.
struct Selection {
    int model = 0;
    std::optional<std::size_t> vertex;
    int pass = 0;
    int unit = 0;
};

enum class Dialog { None, OpenScene, OpenImage, SaveScene, Discard, Help, Restore, Refused };

/// What waits until the user has decided about unsaved changes.
enum class Pending { None, NewScene, OpenScene, OpenFiles, ShowScene, Quit };

/// The visible part of the texture plane.
struct Plane {
    float s = 0.5F; ///< the coordinates at the centre of the panel
    float t = 0.5F;
    float extent = 1.6F; ///< how much of the plane the panel's shorter side shows
};

/// A sentence for the user, in the status bar until it is dismissed.
struct Notice {
    std::string text;           ///< empty: nothing to say
    std::filesystem::path file; ///< one that it may help to look into; empty: none
};

/// What the findings were made of.
struct Diagnosis {
    Scene scene;
    std::vector<std::shared_ptr<const TextureImage>> images;
    DriverFacts driver;
};

/// Everything that the window remembers beyond the scene, as plain values.
struct Session {
    Session(Scene start, ImageSource source);

    Scene scene; ///< what is shown and edited; `history.current()` but for an edit in progress
    History history;
    Scene saved; ///< as the file has it
    ImageSource images;
    std::filesystem::path file; ///< empty: never saved
    bool needsFit = false;      ///< the camera has not yet been fitted to the view's shape

    Views views; ///< who draws the scene, and how one looks at it
    Playback playback;
    bool showsFrameTime = true; ///< off where two pictures of the window should be the same
    Selection selection;
    Plane plane;
    Columns columns;
    bool showRq = false;      ///< whether the vertex list shows r and q
    bool movesVertex = false; ///< the drag in the texture space holds a vertex, not the plane
    std::optional<std::size_t> revealedVertex; ///< the list was scrolled to this one already

    std::vector<Finding> findings; ///< about the scene, kept by `diagnoseSession`
    Diagnosis diagnosis;
    std::string wantedParam; ///< the parameters are scrolled there with the next frame; empty: not
    std::optional<Section> wantedSection; ///< is opened and scrolled to with the next frame
    std::string shownParam;               ///< the one that was scrolled to, framed until the next click

    std::string revealedCommand; ///< the command view was scrolled to this parameter already

    Dialog dialog = Dialog::None;
    Pending pending = Pending::None;
    std::vector<std::filesystem::path> pendingFiles;
    std::vector<Error> refused; ///< of several files: those that could not be opened, until one has read it
    FileBrowser browser;
    bool quitConfirmed = false;

    Background* background = nullptr; ///< the host's; nullptr: files are read on the spot
    UnsavedWork* unsaved = nullptr;   ///< the host's; nullptr: nothing is kept beyond the window
    std::vector<Load> loads;          ///< what is on its way, in the order in which it was asked for
    std::set<std::string> damaged;    ///< files of `images` that changed and can't be read any more
    std::shared_ptr<Load> readyScene; ///< loaded, and waits for an answer about unsaved changes
    FileView fileView;
    std::optional<Tab> wantedTab; ///< comes to the front with the next frame
    Tab shownTab = Tab::Vertices; ///< is in front
    GlslView glsl;
    std::shared_ptr<LevelsWorker> levelsAtOnce;             ///< where there is no Background
    std::shared_ptr<reference::DrawWorker> referenceAtOnce; ///< likewise

    std::shared_ptr<reference::ProbeWorker> probeWorkerAtOnce; ///< likewise
    Explaining explaining;

    Notice notice;
    std::string lastChanged;          ///< the path of the parameter that was edited last
    std::shared_ptr<const Mesh> mesh; ///< of the selected model, kept by `selectedMesh`
    std::array<int, 3> meshKey{-1, 0, 0};
    Probe* probe = nullptr; ///< for tests: records where widgets are
};

/// A session for a scene whose images are loaded. A camera that nobody has chosen, that of the default scene,
/// is fitted to the view when its shape is known, so that a narrow window cuts nothing off.
[[nodiscard]] Session makeSession(Scene scene, ImageSource images, std::filesystem::path file = {});

/// To be called before a frame is rendered and its panels are drawn: fits a camera that waits for it, brings
/// selections back into the scene.
void settle(Session& session, const Layout& layout);

/// Lets the clock run for `seconds` of real time, if it plays and something depends on it.
void advance(Session& session, double seconds);

/// Whether the next frame differs from this one without any input.
[[nodiscard]] bool isMoving(const Session& session);

/// To be called after an edit of `session.scene`: remembers it for undo under the name `what`. `path` is the
/// parameter that changed, where it is one.
void recordEdit(Session& session, std::string_view what, std::string_view path = {});

/// Ends a step of the history: the next edit is a new one even if it has the same name.
void sealEdit(Session& session);

void undo(Session& session);
void redo(Session& session);

/// Whether closing would lose something. Looking around in a scene that was never saved doesn't count.
[[nodiscard]] bool isDirty(const Session& session);

/// "earth.json • Texplorer": the bullet says that there are unsaved changes.
[[nodiscard]] std::string windowTitle(const Session& session);

/// Who makes the levels of the textures: the Background's worker, or one that makes them at once.
[[nodiscard]] LevelsWorker& levelsOf(Session& session);

/// Who draws the reference's picture: the Background's worker, or one that draws at once.
[[nodiscard]] reference::DrawWorker& referenceOf(Session& session);

/// Who explains pixels: the Background's worker, or one that does it at once.
[[nodiscard]] reference::ProbeWorker& probeWorkerOf(Session& session);

// What the panels show.
[[nodiscard]] Model* selectedModel(Session& session);
[[nodiscard]] const Mesh& selectedMesh(Session& session); ///< empty where no model is selected
[[nodiscard]] Pass& selectedPass(Session& session);
[[nodiscard]] Unit& selectedUnit(Session& session);
[[nodiscard]] std::string selectedUnitPath(const Session& session); ///< "passes[0].units[1]"
/// The texture that is bound to the selected unit, as glBindTexture makes one both used and edited. nullptr:
/// none.
[[nodiscard]] Texture* boundTexture(Session& session);
[[nodiscard]] const Texture* boundTexture(const Session& session);

} // namespace texplorer::ui
