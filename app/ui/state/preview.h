#pragma once

#include "texplorer/scene/scene.h"

#include <memory>
#include <string>

namespace texplorer::ui {

/// The scene that the view shows instead of the document's while the pointer rests on a choice. It is not
/// recorded, diagnosed or saved.
struct Preview {
    std::string choice; ///< identifies it: "textures[0].wrapS=GL_CLAMP"
    std::string text;   ///< the text in the view: "Wrap s: Clamp (legacy)"
    std::shared_ptr<const Scene> scene;
    Scene madeOf;        ///< the document's scene without the edit
    bool wanted = false; ///< requested in this frame
};

} // namespace texplorer::ui
