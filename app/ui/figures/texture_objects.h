#pragma once

#include "app/ui/model/session.h"
#include "texplorer/reference/texture_calls.h"

#include <glm/vec3.hpp>
#include <imgui.h>

#include <array>
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

/// A call of a program, and what it shows.
struct ToldCall {
    objects::Call call;
    const char* remark;
};

/// texbind.c of the OpenGL Programming Guide: two objects, and an environment that is set once.
[[nodiscard]] const std::vector<ToldCall>& texbindCalls();

/// An image for glTexImage2D: 2 x 2 texels of two colours, the first one at (0, 0).
struct Board {
    glm::vec3 first;
    glm::vec3 second;
};
inline constexpr std::array boards{
    Board{{0.10F, 0.10F, 0.10F}, {1, 1, 1}},
    Board{{0.10F, 0, 0}, {1, 0.15F, 0.10F}},
    Board{{0.10F, 0.25F, 0.75F}, {1, 0.85F, 0.30F}},
};

void drawBoardImage(ImVec2 low, float side, const Board& board);

/// Draws a square with the coordinates 0 to 1 through the units up to `last`: pale blue if none has a
/// texture.
void drawFragments(ImVec2 low, float side, const objects::TextureNames& names, std::size_t last);

} // namespace texplorer::ui
