#pragma once

#include "app/ui/widgets/palette.h"

#include <span>
#include <string>

namespace texplorer::ui {

struct TipLine {
    std::string words; ///< in the window's language; wrapped
    ImU32 ink = color::text;
    bool code = false;
};

/// A tooltip of the last item. It covers neither the item's row, nor its menu or list, nor the view, which
/// shows the effect: it is below or above the item, next to its panel, or at the lower edge.
void showTip(std::span<const TipLine> lines);

} // namespace texplorer::ui
