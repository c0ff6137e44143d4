#pragma once

#include "core/diagnosis/diagnosis.h"
#include "core/scene/params/params.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

// What a control says when the pointer rests on it. Each is called after the item that it explains.

void text(std::string_view words);
void dimText(std::string_view words);
/// As many lines as it takes in the room that there is.
void wrappedText(std::string_view words);
void dimWrappedText(std::string_view words);

/// The GL call for a texture of this target, the help, the choice, how to edit it, what the diagnosis says
/// (nullptr: nothing) and how to reset it: with ↺ where the row `hasSign`. Of a choice that says itself what
/// it is, it says the more only where that takes no room from what is below the pointer.
void paramTip(const ParamRow& row, const Value& value, const Value& initial, Target target,
              const Finding* idle, const Finding* problem, bool hasSign = true);

/// A triangle with an exclamation mark, as high as a control.
void warningSign();
/// An i in a circle, for what is worth knowing and not wrong.
void noteSign();

/// One of an enumeration's choices: its label, GL's name and its help, in the status bar or beside its list.
void choiceTip(const EnumRow& choice);

} // namespace texplorer::ui
