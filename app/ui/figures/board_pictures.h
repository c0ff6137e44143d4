#pragma once

#include "texplorer/reference/texture_names.h"

#include <glm/vec3.hpp>
#include <imgui.h>

#include <array>

namespace texplorer::ui {

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
