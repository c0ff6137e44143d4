#pragma once

#include "app/screenshot/gl/picture_texts.h"
#include "texplorer/compare/comparison.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::screenshot {

using AxisValues = std::vector<std::pair<std::string, std::string>>; ///< paths and values

/// What is in a place of a sheet.
struct SheetCell {
    PixelRect rect; ///< from the sheet's upper left
    AxisValues values;
    std::vector<Error> warnings{};
    std::optional<std::size_t> differing{}; ///< pixels, where it was compared with the first
    std::optional<Error> error{};           ///< none: it was drawn
};

/// A sheet that was written.
struct WrittenSheet {
    std::string file;
    glm::ivec2 size{0};
    PictureFacts facts;
    std::vector<SheetCell> cells;
};

/// As a document for programs: the sheets in their order.
[[nodiscard]] std::string sheetsJson(const std::vector<WrittenSheet>& sheets);

} // namespace texplorer::screenshot
