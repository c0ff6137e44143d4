#pragma once

#include "app/ui/widgets/palette.h"
#include "texplorer/base/sentence.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// One line of help for the item under the pointer, in English: the status bar translates it.
struct Hint {
    Sentence words; ///< empty: the item has no help
    bool isProblem = false;
};

/// Begins a frame. `room`: pixels for a hint in the status bar; 0: hints are shown as tooltips.
void beginHints(float room);

/// Ends the collection of hints: later ones in this frame are shown as tooltips. Returns the hint for the
/// status bar.
Hint endHints();

/// Whether these words fit into one line of the status bar.
[[nodiscard]] bool fitsBelow(const Sentence& words);

/// Shows the words there. The last hint of a frame is used.
void hint(Sentence words, bool isProblem = false);

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
void helpTip(const Sentence& text);

/// Names the last item for tests, see noteItem, and shows its help.
void item(std::string_view name, const Sentence& help);

} // namespace texplorer::ui
