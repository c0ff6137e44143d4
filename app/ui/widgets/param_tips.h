#pragma once

#include "core/diagnosis/diagnosis.h"
#include "core/scene/params/params.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

// What a control says when the pointer rests on it. Each is called after the item that it explains.

void text(std::string_view words);
void dimText(std::string_view words);

/// The GL call for a texture of this target, the help, the choice, how to edit it, what the diagnosis says
/// (nullptr: nothing) and how to reset it.
void paramTip(const ParamRow& row, const Value& value, const Value& initial, Target target,
              const Finding* idle, const Finding* problem);

/// A triangle with an exclamation mark, as high as a control.
void warningSign();
/// An i in a circle, for what is worth knowing and not wrong.
void noteSign();

/// One of an enumeration's choices, beside its list.
void choiceTip(const EnumRow& choice);

} // namespace texplorer::ui
