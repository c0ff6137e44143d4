#pragma once

// The parts of a parameter's line: controls, signs and its menu.

#include "app/ui/model/session.h"
#include "app/ui/widgets/drag_number.h"
#include "app/ui/widgets/segments.h"
#include "app/ui/widgets/tip.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>
#include <glm/glm.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>

namespace texplorer::ui {

/// The struct that a group of rows shows and edits, and one with the initial values.
struct Owner {
    const void* values = nullptr;
    const void* initial = nullptr;
    std::string path; ///< "textures[0]"; empty for the scene itself
    /// Called before an edit is submitted; false cancels it.
    std::function<bool(const ParamRow& row, const Value& value)> accepts = {};
    /// The name of a choice in this place; empty: the name in its row.
    std::function<std::string(const ParamRow& row, const EnumRow& choice)> labelOf = {};

    [[nodiscard]] std::string pathOf(const ParamRow& row) const {
        return path.empty() ? std::string(row.key) : fmt::format("{}.{}", path, row.key);
    }
};

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

/// A swatch that opens the popup "picker" when pressed, and what it has inside. They are separate so that the
/// swatch stays the "last item" of the line.
bool colorControl(const glm::vec4& value);
bool colorPicker(const Session& session, glm::vec4& value, const std::string& name);

/// The last widget opens the menu of its row, by a right click or the menu key.
void opensParamMenu();

/// The menu of a row while it is open: to reset and pin it, for its key frames and for the sheet. Returns
/// true if it resets the row.
[[nodiscard]] bool paramMenu(const Session& session, const ParamRow& row, const std::string& path,
                             const Value& initial, bool changed);

/// "Reset to 1"
[[nodiscard]] Sentence resetWords(const ParamRow& row, const Value& initial);

/// A diamond after the label of a parameter with key frames: filled if there is one at the present time.
void keySign(const Session& session, const std::string& path);

/// A sign next to the label of a parameter: shows its problem, and after a click the fixes.
void problemSign(const Session& session, const std::string& path, const Finding& problem);

} // namespace texplorer::ui
