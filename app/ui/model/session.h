#pragma once

#include "app/ui/model/document.h"
#include "app/ui/model/services.h"
#include "app/ui/model/window_state.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

/// Everything that the panels show and change.
struct Session {
    explicit Session(Services lent, Document start = {defaultScene(), ImageSource{}});

    Services services;
    Document document;
    WindowState window;
    std::size_t documents = 0; ///< how many have been replaced: what panels remember of those is out of date
};

/// Another document takes the place of this one and is looked at anew, by the renderers that the user has
/// chosen; the rest of the window stays. Gives up the loads of the old one, and closes the lesson, unless it
/// is the lesson's.
void replaceDocument(Session& session, Document document);
/// The same of another state of this document: it is looked at as before.
void exchangeDocument(Session& session, Document document);

/// The renderers that a lesson's step has chosen give way to those of before, unless the user has chosen
/// others since.
void endLessonPictures(WindowState& window);

/// What one sees is what the lists should be about: a model that isn't drawn gives way to the first that is.
void leaveHiddenModel(Session& session);

/// To be called before a frame is rendered and its panels are drawn: fits a camera that waits for it, brings
/// selections back into the scene.
void settle(Session& session, const Layout& layout);

/// Lets the clock run for `seconds` of real time, if it plays and something depends on it.
void advance(Session& session, double seconds);

/// Whether the next frame differs from this one without any input.
[[nodiscard]] bool isMoving(const Session& session);

/// To be called after an edit of the scene: remembers it for undo under the name `what`. `path` is the
/// parameter that changed, where it is one. Of what has key frames it becomes one (timeline_edits.h).
void recordEdit(Session& session, std::string_view what, std::string_view path = {});

/// The same of a scene that took the place of the document's: what is another one in it is no edit of
/// parameters, which might set key frames.
void recordScene(Session& session, std::string_view what, std::string_view path = {});

/// The edit in progress, which no `sealEdit` has ended yet, never was: neither undo nor redo knows of it.
void takeBackEdit(Session& session);

/// To be called where the scene became another one: what is selected gives way to what is there and is seen.
void bringSelectionBack(Session& session);

/// Ends a step of the history: the next edit is a new one even if it has the same name.
void sealEdit(Session& session);

void undo(Session& session);
void redo(Session& session);
/// As many undos or redos as lead to a step of the history.
void goToStep(Session& session, std::size_t step);
/// The scene becomes what the file has, or what it was at the start: a step of undo.
void resetToSaved(Session& session);

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
