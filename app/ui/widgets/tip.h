#pragma once

#include "app/ui/widgets/palette.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

struct TipLine {
    std::string words; ///< in the window's language; wrapped
    ImU32 ink = color::text;
    bool code = false;
};

/// A tooltip of the last item. It covers neither the item's row, nor its menu or list, nor the view, which
/// shows the effect: it is below or above the item, next to its panel, or at the lower edge.
void showTip(std::span<const TipLine> lines);

/// Whether the last item, which may be disabled, shows help: the pointer rests on it.
[[nodiscard]] bool wantsHelp();

/// After a click the user looks at its effect: a tooltip, which covers it, waits until the pointer moves.
[[nodiscard]] bool hasJustClicked();

/// Help for the last item while it wants it, in English: in the status bar, or as a tooltip if it does not
/// fit there.
void helpTip(std::string_view text);

} // namespace texplorer::ui
