#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/owner.h"
#include "app/ui/widgets/segments.h"

#include <optional>
#include <string>

namespace texplorer::ui {

/// The name of a row's choice in this place.
[[nodiscard]] std::string nameOfChoice(const Session& session, const Owner& owner, const ParamRow& row,
                                       const EnumRow& choice);

/// The layout of a row's choices as buttons; nothing if they are too many or too long.
[[nodiscard]] std::optional<SegmentPlan> planChoices(const Session& session, const Owner& owner,
                                                     const ParamRow& row, float width, std::size_t maxLines);

/// Draws the choices by a plan, or, without one, as a list in the item's width. The choice under the pointer
/// is previewed. `chosenInk`: for the chosen one of a plan. The name in tests is "path=NAME". Returns true if
/// `value` changed.
bool enumControl(const Session& session, const Owner& owner, const ParamRow& row, EnumValue& value,
                 const std::string& path, const std::optional<SegmentPlan>& plan,
                 std::optional<ImU32> chosenInk);

} // namespace texplorer::ui
