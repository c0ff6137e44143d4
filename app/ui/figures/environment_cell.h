#pragma once

#include "app/ui/widgets/pictures.h"
#include "texplorer/reference/shading/environment_table.h"

#include <glm/vec4.hpp>
#include <imgui.h>

#include <string>

namespace texplorer::ui {

/// The content of a cell of the table if there is no room for everything.
enum class CellText { Symbols, Numbers, Pictures };

/// The layout of the table's cells: a picture on the left or above, and one or both texts next to it or
/// below.
struct CellPlan {
    ImVec2 size{};      ///< of a cell
    float text = 0;     ///< size of its letters
    float side = 0;     ///< size of its picture; 0: none
    bool above = false; ///< the picture is above the text
    bool dense = false; ///< equations have no blanks
    bool tight = false; ///< equations of sums have two lines
    bool symbols = true;
    bool numbers = true;
    bool apart = false; ///< symbols and a picture do not fit together

    [[nodiscard]] bool hasBoth() const { return symbols && numbers; }
};

/// The best plan for cells of this size; `wanted` is shown if not everything fits.
[[nodiscard]] CellPlan planCells(ImVec2 size, CellText wanted);

/// The minimum height of a row of cells of this width.
[[nodiscard]] float minCellHeight(float width, CellText wanted);

/// All pictures in one image, see reference::environmentPictures, and its texture.
struct CellPictures {
    view::PictureHandle all = view::PictureHandle::None;
    float width = 1; ///< texels of one picture
    float height = 1;
};

/// Draws the cell of a mode and a format between `low` and `low` + plan.size.
void drawEnvironmentCell(const CellPlan& plan, ImVec2 low, std::size_t column, std::size_t row,
                         const reference::TableColors& colors, const CellPictures& pictures);

/// A colour; its right half is blended over a board by its alpha.
void colorPatch(ImVec2 low, ImVec2 high, glm::vec4 value);

/// "230 77 51 255"
[[nodiscard]] std::string bytesText(glm::vec4 color);

} // namespace texplorer::ui
