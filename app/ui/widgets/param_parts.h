#pragma once

// The parts of a parameter's line: controls, signs and its menu.

#include "app/ui/model/session.h"
#include "app/ui/widgets/owner.h"
#include "app/ui/widgets/segments.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>

namespace texplorer::ui {

/// The layout of a row's choices as buttons; nothing if they are too many or too long.
[[nodiscard]] std::optional<SegmentPlan> planChoices(const Session& session, const Owner& owner,
                                                     const ParamRow& row, float width, std::size_t maxLines);

/// Draws the choices by a plan, or, without one, as a list in the item's width. The choice under the pointer
/// is previewed. `chosenInk`: for the chosen one of a plan. The name in tests is "path=NAME". Returns true if
/// `value` changed.
bool enumControl(const Session& session, const Owner& owner, const ParamRow& row, EnumValue& value,
                 const std::string& path, const std::optional<SegmentPlan>& plan,
                 std::optional<ImU32> chosenInk);

// Controls for values with several numbers, in the current item width; `path` is the name in tests. Each
// returns true if `value` changed.

/// A number for each component, with its letter: x, y, z, w.
bool vectorControl(const Session& session, const ParamRow& row, std::span<float> numbers,
                   const std::string& path);

/// Rows as in written mathematics, although OpenGL stores columns. A row has the letter of the coordinate
/// that it computes.
bool matrixControl(const Session& session, const ParamRow& row, glm::mat4& value, const std::string& path);

/// A swatch that opens colorPopup when pressed; the popup is separate so that the swatch stays the "last
/// item" of the line.
bool colorControl(glm::vec4& value);
bool colorPopup(const Session& session, glm::vec4& value, const std::string& path);

/// The last widget opens the menu of its row, by a right click or the menu key.
void opensParamMenu();

/// The menu of a row while it is open: to reset and pin it, for its key frames and for the sheet. Returns
/// true if it resets the row.
[[nodiscard]] bool paramMenu(const Session& session, const ParamRow& row, const std::string& path,
                             const Value& initial, bool changed);

/// "Reset to 1"
[[nodiscard]] std::string resetWords(const ParamRow& row, const Value& initial);

/// A diamond after the label of a parameter with key frames: filled if there is one at the present time.
void keySign(const Session& session, const std::string& path);

/// A sign next to the label of a parameter: shows its problem, and after a click the fixes.
void problemSign(const Session& session, const std::string& path, const Finding& problem);

} // namespace texplorer::ui
