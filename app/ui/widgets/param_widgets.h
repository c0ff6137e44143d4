#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/drag_number.h"
#include "app/ui/widgets/widget_places.h"
#include "core/scene/params/params.h"

#include <fmt/core.h>
#include <imgui.h>

#include <functional>
#include <string>

namespace texplorer::ui {

/// The struct that a group of rows edits, beside one that holds the initial values.
struct Owner {
    void* values = nullptr;
    const void* initial = nullptr;
    std::string path; ///< "textures[0]"; empty for the scene itself
    /// Asked before a value is written; false leaves everything as it was.
    std::function<bool(const ParamRow& row, const Value& value)> accepts = {};
    /// What a choice is called here; empty: as its row says.
    std::function<std::string(const ParamRow& row, const EnumRow& choice)> labelOf = {};

    [[nodiscard]] std::string pathOf(const ParamRow& row) const {
        return path.empty() ? std::string(row.key) : fmt::format("{}.{}", path, row.key);
    }
};

/// One line: label, control, and a sign to reset it where it differs from the initial value; a right click
/// opens a menu that resets and pins it. The control suits the row's kind. Records the edit. True where the
/// value changed.
bool paramWidget(Session& session, const Owner& owner, const ParamRow& row);

/// The control alone, for panels with lines of their own. The buttons of a choice may have so many `lines`.
/// True where the value changed.
bool paramControl(Session& session, const Owner& owner, const ParamRow& row, float width,
                  std::size_t lines = 1);

/// The control alone, of a Float whose places are powers: a slider from the least value to `end`.
bool paramSlider(Session& session, const Owner& owner, const ParamRow& row, float width, float end);

/// Writes a value as its control does: checked, asked for, recorded. True where it changed.
bool assignParam(Session& session, const Owner& owner, const ParamRow& row, const Value& value);

/// How the rows of a table are drawn.
struct RowOptions {
    bool captions = true; ///< the groups have their names above them
    /// Rows that are drawn elsewhere.
    std::function<bool(const ParamRow& row)> leavesOut = {};
    /// Rows that are folded beside those that belong to a choice that isn't made.
    std::function<bool(const ParamRow& row)> folds = {};
    /// Called where a group of rows ends.
    std::function<void(std::string_view group)> after = {};
};

/// Every row of a table: those that may have an effect on these values, group by group, and below them the
/// others, folded.
void paramRows(Session& session, const Owner& owner, const StructTable& table,
               const RowOptions& options = {});

/// Whether a row's value can matter beside the others: the slices of a cube can't.
[[nodiscard]] bool isRelevant(const Session& session, const Owner& owner, const ParamRow& row);

/// A button as wide as it is high; `name` is what tests call it.
bool squareButton(const char* sign, std::string_view name, std::string_view help, bool enabled);

/// Ends a step of undo when the last widget is let go.
void sealAfterItem(Session& session);

/// What the last widget is, where the pointer rests on it: in the status bar, or where that has no room a
/// tooltip.
void helpTip(std::string_view text);

/// A small dim caption over a group.
void caption(std::string_view text);

} // namespace texplorer::ui
