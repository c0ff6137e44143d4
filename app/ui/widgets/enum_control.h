#pragma once

#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/segments.h"

#include <optional>
#include <string>

namespace texplorer::ui {

/// What a choice of a row is called here.
[[nodiscard]] std::string nameOfChoice(const Session& session, const Owner& owner, const ParamRow& row,
                                       const EnumRow& choice);

/// How the choices of a row lie side by side; nothing where they are many or their names too long.
[[nodiscard]] std::optional<SegmentPlan> planChoices(const Session& session, const Owner& owner,
                                                     const ParamRow& row, float width, std::size_t mostLines);

/// The choices as a plan has them, or, without one, as a list in the item's width. The one that the pointer
/// rests on is previewed. `chosenInk`: of the chosen one of a plan. Tests call each "path=NAME". True where
/// `value` changed.
bool enumControl(Session& session, const Owner& owner, const ParamRow& row, EnumValue& value,
                 const std::string& path, const std::optional<SegmentPlan>& plan,
                 std::optional<ImU32> chosenInk);

} // namespace texplorer::ui
