#pragma once

#include "app/ui/model/document.h"
#include "app/ui/model/services.h"
#include "app/ui/model/step.h"
#include "app/ui/model/window_state.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// Everything that the panels show and edit.
struct Session {
    explicit Session(Services lent, Document start = {defaultScene(), ImageSource{}});

    Services services;
    Document document;
    WindowState window;
    std::vector<Step> steps; ///< submitted in this frame
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

/// Call after an edit of the scene: records it for undo under the name `what`. `path` is the changed
/// parameter, if it is one. An edit of a parameter with key frames becomes a key frame (timeline_edits.h).
void recordEdit(Session& session, std::string_view what, std::string_view path = {});

/// The same after the document's scene was replaced: its differences are not edits of parameters, which could
/// set key frames.
void recordScene(Session& session, std::string_view what, std::string_view path = {});

/// Removes the edit in progress, before `sealEdit`, from undo and redo.
void takeBackEdit(Session& session);

/// Call after the scene was replaced: selects existing and visible objects.
void bringSelectionBack(Session& session);

/// Has a step made at the end of the frame (app/ui/editor).
void submit(Session& session, Step step);

/// The same with the changes that a function makes in a copy of the scene. It may change the lengths of a
/// unit's or a texture's lists, but not those of textures, models and passes, which other parts name by their
/// index.
void submit(Session& session, std::string name, const std::function<void(Scene&)>& change,
            std::string path = {});

/// Ends an undo step, after the submitted ones: the next edit starts a new one even with the same name.
void sealEdit(Session& session);

void undo(Session& session);
void redo(Session& session);
/// Undoes or redoes until the step of the history.
void goToStep(Session& session, std::size_t step);
/// Resets the scene to its file, or to its initial state: an undo step.
void resetToSaved(Session& session);

// The objects that the panels show.
[[nodiscard]] Model* selectedModel(Session& session);
[[nodiscard]] const Mesh& selectedMesh(Session& session); ///< empty if no model is selected
[[nodiscard]] Pass& selectedPass(Session& session);
[[nodiscard]] Unit& selectedUnit(Session& session);
[[nodiscard]] Unit& selectedUnit(Scene& scene, const Selection& selection); ///< in a copy of the scene
[[nodiscard]] std::string selectedUnitPath(const Session& session);         ///< "passes[0].units[1]"
/// The texture bound to the selected unit, which is both used and edited as after glBindTexture. nullptr:
/// none.
[[nodiscard]] Texture* boundTexture(Session& session);
[[nodiscard]] const Texture* boundTexture(const Session& session);

} // namespace texplorer::ui
