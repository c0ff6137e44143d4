#pragma once

#include "core/scene/params.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

// What a control says when the pointer rests on it. Each is called after the item that it explains.

void text(std::string_view words);
void dimText(std::string_view words);

/// The GL call, the help, the choice, how to edit it, why it has no effect (`inert`, empty: it has) and how
/// to reset it.
void paramTip(const ParamRow& row, const Value& value, const Value& initial, const std::string& inert);

/// One of an enumeration's choices, beside its list.
void choiceTip(const EnumRow& choice);

} // namespace texplorer::ui
