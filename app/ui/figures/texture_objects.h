#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "core/objects/texture_calls.h"

#include <vector>

namespace texplorer::ui {

/// A call with what it gave back.
struct LoggedCall {
    objects::Call call;
    objects::Answer answer{};
};

/// A context of its own, which begins as a new one does; the scene isn't touched.
struct TextureObjectsState {
    objects::TextureNames names{};
    objects::TextureNames before{}; ///< the last call
    std::vector<LoggedCall> log{};
    std::size_t played = 0; ///< how many calls of texbind.c were made; 0: it isn't played
};

/// Texture objects and units: each button is a call, and what it changed is lit.
void drawTextureObjects(Session& session, TextureObjectsState& state, const Pictures& pictures);

} // namespace texplorer::ui
