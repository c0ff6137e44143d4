#pragma once

#include "app/ui/widgets/pictures.h"
#include "core/reference/shading/environment_table.h"

#include <glm/vec4.hpp>
#include <imgui.h>

#include <string>

namespace texplorer::ui {

/// What a cell of the table says where it has no room for all.
enum class CellText { Symbols, Numbers, Pictures };

/// How the cells of the table share their room: a picture at the left or above, and beside or below it one or
/// both texts.
struct CellPlan {
    ImVec2 size{};      ///< of a cell
    float text = 0;     ///< the size of its letters
    float side = 0;     ///< of its picture; 0: there is none
    bool above = false; ///< the picture is above the text
    bool dense = false; ///< equations are without blanks
    bool tight = false; ///< and those of sums have two lines
    bool symbols = true;
    bool numbers = true;
    bool apart = false; ///< there is no room for symbols and a picture

    [[nodiscard]] bool hasBoth() const { return symbols && numbers; }
};

/// What suits cells of this size; `wanted` where there is no room for all of it.
[[nodiscard]] CellPlan planCells(ImVec2 size, CellText wanted);

/// The least height of a row of cells that are so wide.
[[nodiscard]] float leastCellHeight(float width, CellText wanted);

/// All the pictures in one, see reference::environmentPictures, and how they are shown.
struct CellPictures {
    view::PictureHandle all = view::PictureHandle::None;
    float width = 1; ///< texels of one of them
    float height = 1;
};

/// What is in the cell of a mode and a format, between `low` and `low` + plan.size.
void drawEnvironmentCell(const CellPlan& plan, ImVec2 low, std::size_t column, std::size_t row,
                         const reference::TableColors& colors, const CellPictures& pictures);

/// A colour, its right half over a board as far as its alpha lets it shine through.
void colorPatch(ImDrawList& draw, ImVec2 low, ImVec2 high, glm::vec4 value);

/// "230 77 51 255"
[[nodiscard]] std::string bytesText(glm::vec4 color);

} // namespace texplorer::ui
