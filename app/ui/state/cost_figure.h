#pragma once

#include "app/view/texture_cost.h"
#include "texplorer/texture/levels_source.h"

#include <optional>
#include <string>

namespace texplorer::ui {

/// What textures cost on this driver, and whether that is being measured.
struct CostFigure {
    std::optional<view::CostSubject> subject{}; ///< of a measurement; nothing: none is going on
    view::TextureCosts costs{};
    std::string driver{};                    ///< its GL_RENDERER
    std::optional<LevelsRequest> measured{}; ///< the scene's texture in them
};

} // namespace texplorer::ui
