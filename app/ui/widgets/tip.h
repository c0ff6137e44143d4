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

/// A tooltip of the last item, where it covers neither the row of that, nor the menu or list that it is in,
/// nor the view, which shows what comes of it: below or above the item, beside its panel, or at the lower
/// edge.
void showTip(std::span<const TipLine> lines);

} // namespace texplorer::ui
