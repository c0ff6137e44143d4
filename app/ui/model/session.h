#pragma once

#include "app/ui/model/document.h"
#include "app/ui/model/requests.h"
#include "app/ui/model/services.h"
#include "app/ui/model/window_state.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

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
    WindowState window;
    mutable Outbox out;       ///< of this frame
    mutable MeshOfModel mesh; ///< see selectedMesh
    std::size_t documents =
        0; ///< the number of replaced documents, for panels to detect that their state is out of date
};

/// Replaces the document and resets how it is shown, with the renderers that the user has chosen; the rest of
/// the window stays. Cancels the loads of the old document, and closes the lesson, unless the new document
/// belongs to it.
void replaceDocument(Session& session, Document document);
/// Replaces the document by another state of it, without resetting how it is shown.
void exchangeDocument(Session& session, Document document);

/// Restores the renderers that were shown before a lesson's step chose others, unless the user has chosen
/// some since.
void endLessonPictures(WindowState& window);

/// Selects the first visible model if the selected one is not drawn.
void leaveHiddenModel(Session& session);

/// Call before a frame is rendered and its panels are drawn: fits a camera that needs it, and corrects
/// selections that are not in the scene.
void settle(Session& session, const Layout& layout);

/// Advances the clock by `seconds` of real time, if it plays and something depends on it.
void advance(Session& session, double seconds);

/// Whether the next frame differs even without input.
[[nodiscard]] bool isMoving(const Session& session);

/// The scene at the present time, which panels show and edit: parameters with key frames have the values that
/// are seen.
[[nodiscard]] const Scene& presentScene(const Session& session);

/// Call before panels are drawn, and again after the scene has changed.
void showPresent(Session& session);

/// Call after the scene was replaced: selects existing and visible objects.
void bringSelectionBack(Session& session);

/// A step with the changes that a function makes in a copy of the scene (editThat), or without edits.
[[nodiscard]] Step stepThat(const Session& session, std::string name,
                            const std::function<void(Scene&)>& change, std::string path = {});

/// Has something done at the end of the frame (app/ui/editor), after the earlier requests.
void act(const Session& session, Action action);
/// The same for a change of the window's state.
void change(const Session& session, std::function<void(WindowState&)> make);
/// The same for panels, their places and sizes.
void rearrange(const Session& session, std::function<void(Workspace&)> make);

/// Has a step made at the end of the frame, unless it has no edits and selects nothing.
void submit(const Session& session, Step step);

/// Submits the step with the changes of a function.
void submit(const Session& session, std::string name, const std::function<void(Scene&)>& change,
            std::string path = {});
/// The same for a part of a drag, which continues the undo step before it.
void submitDrag(const Session& session, std::string name, const std::function<void(Scene&)>& change,
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
/// The texture bound to the selected unit, which is both used and edited as after glBindTexture. nullptr:
/// none.
[[nodiscard]] const Texture* boundTexture(const Session& session);

} // namespace texplorer::ui
