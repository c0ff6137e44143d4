#pragma once

#include "core/scene/scene.h"

#include <functional>
#include <memory>
#include <string>

namespace texplorer::ui {

struct Session;

/// What the view shows in the place of the document's scene while the pointer rests on a choice. Nothing else
/// knows of it: it is neither recorded nor diagnosed nor saved.
struct Preview {
    std::string choice; ///< tells it from the next one: "textures[0].wrapS=GL_CLAMP"
    std::string text;   ///< what the view says of it: "Wrap s: Clamp (legacy)"
    std::shared_ptr<const Scene> scene;
    Scene madeOf;        ///< the document's scene without the edit
    bool wanted = false; ///< somebody asked for it in this frame
};

/// To be called in every frame in which the pointer rests on a choice: the view shows the document's scene
/// with this edit from the next frame on, up to the first one in which nobody asks. A scene that names an
/// image that isn't loaded is not shown. Where several ask, the last one is heard.
void preview(Session& session, std::string_view choice, std::string_view text,
             const std::function<void(Scene&)>& edit);

/// To be called at the end of a frame: a preview that nobody has asked for in it is over.
void endPreview(Session& session);

/// The scene that the view shows, with all its passes: the document's, the one that is previewed, or A.
[[nodiscard]] const Scene& shownScene(const Session& session);

} // namespace texplorer::ui
