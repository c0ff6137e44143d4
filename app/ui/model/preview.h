#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/scene/scene.h"

#include <functional>

namespace texplorer::ui {

struct Session;
struct Preview;

/// Call in every frame in which the pointer rests on a choice. The view shows the document's scene with this
/// edit from the next frame on, until the first frame without a call. A scene with an image that is not
/// loaded is not shown. If there are several calls, the last one is used.
void preview(const Session& session, std::string_view choice, const Sentence& text,
             const std::function<void(Scene&)>& edit);

/// Call at the end of a frame: ends a preview that was not requested in it.
void endPreview(Session& session);

/// Call after edits, undo and redo: the choice under the pointer is not previewed until the pointer leaves
/// it.
void restPreview(Session& session);

[[nodiscard]] const Preview* shownPreview(const Session& session); ///< nullptr: none is shown

/// The scene in the view, with all its passes: the document's, the previewed one, or A.
[[nodiscard]] const Scene& shownScene(const Session& session);

} // namespace texplorer::ui
