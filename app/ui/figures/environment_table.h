#pragma once

#include "app/ui/figures/environment_cell.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <glm/vec4.hpp>

#include <optional>

namespace texplorer::ui {

struct EnvironmentTableState {
    // Colours that the user has set in the table; nothing: those of the scene.
    std::optional<glm::vec4> fragment;
    std::optional<glm::vec4> texel;
    std::optional<glm::vec4> constant;

    CellText shows = CellText::Symbols; ///< if a cell has no room for both
    bool gradient = false;              ///< the pictures show every hue and alpha, not the texture
};

/// Draws the table of environment modes and base formats for the selected unit and its texture. A click sets
/// the mode and the format of a cell.
void drawEnvironmentTable(const Session& session, EnvironmentTableState& state, const Pictures& pictures);

} // namespace texplorer::ui
