#pragma once

#include "app/ui/widgets/wrapped_text.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/params/params.h"

namespace texplorer::ui {

// The tips of controls. Call each after its item.

/// Shows the GL call for a texture of this target, the help, the choice, how to edit it, the finding of the
/// diagnosis (nullptr: none) and how to reset it: with ↺ if the row `hasSign`. For a choice with its own tip,
/// it shows more only if that covers nothing below the pointer.
void paramTip(const ParamRow& row, const Value& value, const Value& initial, Target target,
              const Finding* idle, const Finding* problem, bool hasSign = true);

/// The tip of one choice of an enumeration: its label, GL's name and its help, in the status bar or next to
/// its list.
void choiceTip(const EnumRow& choice);

} // namespace texplorer::ui
