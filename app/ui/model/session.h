#pragma once

#include "app/ui/model/lesson_run.h"
#include "app/ui/model/requests.h"
#include "app/ui/services/services.h"
#include "app/ui/state/asking.h"
#include "app/ui/state/cost_figure.h"
#include "app/ui/state/document.h"
#include "app/ui/state/look.h"
#include "app/ui/state/recording_choice.h"
#include "app/ui/state/settings.h"
#include "app/ui/state/sheet_choice.h"
#include "app/ui/state/view_settings.h"
#include "app/ui/state/window_state.h"
#include "texplorer/texture/saved_texture.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The mesh of a model, made again when its shape changes.
struct MeshOfModel {
    std::shared_ptr<const Mesh> mesh;
    ShapeOptions shape{}; ///< the source of `mesh`
    MeshData data{};
};

/// Everything that the panels show. Panels get it const: what they change, they request.
struct Session {
    explicit Session(Services lent, Document start = {defaultScene(), ImageSource{}});

    Services services;
    Document document;
    ImageSource drawn; ///< the document's images, with those that renderers draw for textures
    Look look;         ///< reset for another document
    Settings settings; ///< kept between windows
    ViewSettings view; ///< the renderers and how their frames are shown
    Asking asking;
    std::optional<LessonRun> lesson; ///< nothing: none is open
    SheetChoice sheet;
    CostFigure cost;
    RecordingChoice recording;
    TextureSaving saving; ///< its target is that of the selected unit
    WindowState window;
    std::shared_ptr<const reference::ProbeWorker::Answer> tableAnswer; ///< see askAboutTable
    mutable Outbox out;                                                ///< of this frame
    mutable MeshOfModel mesh;                                          ///< see selectedMesh
    std::size_t documents =
        0; ///< the number of replaced documents, for panels to detect that their state is out of date
};

/// Selects the first visible model if the selected one is not drawn.
void leaveHiddenModel(Session& session);

/// The scene at the present time, which panels show and edit: parameters with key frames have the values that
/// are seen.
[[nodiscard]] const Scene& presentScene(const Session& session);

/// Call before panels are drawn, and again after the scene has changed.
void showPresent(Session& session);

/// Call after the scene was replaced: selects existing and visible objects.
void bringSelectionBack(Session& session);

/// A step with the changes that a function makes in a copy of the scene (editThat), or without edits.
[[nodiscard]] Step stepThat(const Session& session, Sentence name, const std::function<void(Scene&)>& change,
                            std::string path = {});

/// Has something done at the end of the frame (app/ui/editor), after the earlier requests.
void act(const Session& session, Action action);
/// The same for panels, their places and sizes.
void rearrange(const Session& session, std::function<void(Workspace&)> make);

/// The same for questions to the workers. If `question` returns true, there is something new, and another
/// frame follows.
void ask(const Session& session, std::function<bool(Session&)> question);
/// The workers: panels see what they have found, and request what they are to do.
[[nodiscard]] inline const Services& workers(const Session& session) {
    return session.services;
}
[[nodiscard]] inline Services& workers(Session& session) {
    return session.services;
}

/// Has a step made at the end of the frame, unless it has no edits and selects nothing.
void submit(const Session& session, Step step);

/// Submits the step with the changes of a function.
void submit(const Session& session, Sentence name, const std::function<void(Scene&)>& change,
            std::string path = {});
/// The same for a part of a drag, which continues the undo step before it.
void submitDrag(const Session& session, Sentence name, const std::function<void(Scene&)>& change,
                std::string path = {});

/// Requests an EndStep.
void sealEdit(const Session& session);

/// Resets the scene to its file, or to its initial state: an undo step.
void resetToSaved(const Session& session);

// The objects that the panels show.
[[nodiscard]] const Model* selectedModel(const Session& session);
[[nodiscard]] Model& selectedModel(Scene& scene, const Selection& selection); ///< in a copy of the scene
[[nodiscard]] const Mesh& selectedMesh(const Session& session); ///< empty if no model is selected
[[nodiscard]] const Pass& selectedPass(const Session& session);
[[nodiscard]] const Unit& selectedUnit(const Session& session);
[[nodiscard]] Unit& selectedUnit(Scene& scene, const Selection& selection); ///< in a copy of the scene
[[nodiscard]] std::string selectedUnitPath(const Session& session);         ///< "passes[0].units[1]"
[[nodiscard]] std::string unitPath(const Selection& selection);             ///< the same
/// The texture of a unit; nullptr: none.
[[nodiscard]] const Texture* textureOf(const Scene& scene, const Unit& unit);
/// The texture bound to the selected unit, which is both used and edited as after glBindTexture. nullptr:
/// none.
[[nodiscard]] const Texture* boundTexture(const Session& session);
/// Its image; nullptr: no texture, or it is not loaded.
[[nodiscard]] std::shared_ptr<const TextureImage> boundImage(const Session& session);

} // namespace texplorer::ui
