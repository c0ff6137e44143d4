#pragma once

#include "core/scene/scene.h"

#include <functional>
#include <memory>
#include <string>

namespace texplorer::ui {

struct Session;

/// The scene that the view shows instead of the document's while the pointer rests on a choice. It is not
/// recorded, diagnosed or saved.
struct Preview {
    std::string choice; ///< identifies it: "textures[0].wrapS=GL_CLAMP"
    std::string text;   ///< the text in the view: "Wrap s: Clamp (legacy)"
    std::shared_ptr<const Scene> scene;
    Scene madeOf;        ///< the document's scene without the edit
    bool wanted = false; ///< requested in this frame
};

/// Call in every frame in which the pointer rests on a choice. The view shows the document's scene with this
/// edit from the next frame on, until the first frame without a call. A scene with an image that is not
/// loaded is not shown. If there are several calls, the last one is used.
void preview(const Session& session, std::string_view choice, std::string_view text,
             const std::function<void(Scene&)>& edit);

/// Call at the end of a frame: ends a preview that was not requested in it.
void endPreview(Session& session);

/// The scene in the view, with all its passes: the document's, the previewed one, or A.
[[nodiscard]] const Scene& shownScene(const Session& session);

} // namespace texplorer::ui
