#include "app/ui/figures/plot.h"
#include "app/ui/figures/texture_objects.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/widgets/points.h"
#include "texplorer/reference/sampling/row_weights.h"

#include <glm/vec4.hpp>

namespace texplorer::ui {
namespace {

constexpr int boardSide = 2; // texels

/// The fragment's colour without a texture: glColor.
constexpr glm::vec4 fragmentColor(0.4F, 0.6F, 1, 1);

glm::vec3 boardTexel(const Board& board, int i, int j) {
    return (i + j) % 2 == 0 ? board.first : board.second;
}

/// The colour of an object's image at (s, t), 0 to 1, by its magnification filter and its wrap modes.
glm::vec4 boardColor(const objects::TextureObject& object, float s, float t) {
    const Texture& state = object.state;
    const bool linear = state.magFilter == MagFilter::Linear;
    const auto across = reference::sampleRow(state.wrapS, linear, s, boardSide);
    const auto up = reference::sampleRow(state.wrapT, linear, t, boardSide);
    glm::vec3 sum(0);
    for (const reference::RowTexel& row : up.taps) {
        for (const reference::RowTexel& texel : across.taps) {
            const auto outside = [](int index) { return index < 0 || index >= boardSide; };
            const bool border = outside(row.index) || outside(texel.index);
            const glm::vec3 color = border ? glm::vec3(state.borderColor)
                                           : boardTexel(boards.at(static_cast<std::size_t>(*object.picture)),
                                                        texel.index, row.index);
            sum += color * (row.weight * texel.weight);
        }
    }
    return {sum, 1};
}

/// A square of cells, the first row at the bottom. `more`: pixels by which each is larger.
template<class ColorOf>
void drawCells(ImVec2 low, float side, int cells, float more, const ColorOf& colorOf) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float cell = side / static_cast<float>(cells);
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const ImVec2 at = low + ImVec2(static_cast<float>(i), static_cast<float>(cells - 1 - j)) * cell;
            draw.AddRectFilled(at, at + ImVec2(cell, cell) + ImVec2(more, more), plotColor(colorOf(i, j)));
        }
    }
    draw.AddRect(low, low + ImVec2(side, side), color::outline);
}

} // namespace

void drawBoardImage(ImVec2 low, float side, const Board& board) {
    drawCells(low, side, boardSide, 0, [&](int i, int j) { return boardTexel(board, i, j); });
}

void drawFragments(ImVec2 low, float side, const objects::TextureNames& names, std::size_t last) {
    constexpr int cells = 12;
    drawCells(low, side, cells, 0.5F, [&](int i, int j) {
        const float s = (static_cast<float>(i) + 0.5F) / cells;
        const float t = (static_cast<float>(j) + 0.5F) / cells;
        glm::vec4 color = fragmentColor;
        for (std::size_t unit = 0; unit <= last; ++unit)
            if (sampledBy(names, unit) == objects::Sampled::Textured)
                color = colorAfter(names, unit, color, boardColor(names.objectOf(unit), s, t));
        return glm::vec3(color);
    });
}

} // namespace texplorer::ui
