#pragma once

#include "app/ui/model/session.h"
#include "texplorer/reference/texture_calls.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// The state: a separate context in its initial state; the scene is not changed.
struct TextureObjectsState {
    objects::TextureNames names{};
    objects::TextureNames before{}; ///< before the last call
    std::vector<std::string> log{}; ///< the calls and their results as C code
    std::size_t played = 0;         ///< the number of calls of texbind.c so far; 0: it is not running
};

/// Draws texture objects and units: each button makes a call, and its changes are highlighted.
void drawTextureObjects(const Session& session, TextureObjectsState& state);

} // namespace texplorer::ui
