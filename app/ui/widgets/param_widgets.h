#pragma once

#include "app/ui/widgets/param_parts.h"

#include <functional>

namespace texplorer::ui {

/// One line: label, control, and a sign to reset it if it differs from the initial value; a right click opens
/// a menu to reset and pin it. The control depends on the row's kind. Submits edits.
void paramWidget(const Session& session, const Owner& owner, const ParamRow& row);

/// The control alone, for panels with their own lines. `lines`: the maximum number of lines for the buttons
/// of a choice.
void paramControl(const Session& session, const Owner& owner, const ParamRow& row, float width,
                  std::size_t lines = 1);

/// The control alone, for a Float on a scale of powers: a slider from the least value to `end`.
void paramSlider(const Session& session, const Owner& owner, const ParamRow& row, float width, float end);

/// Submits another value as its control does: validated and confirmed.
void assignParam(const Session& session, const Owner& owner, const ParamRow& row, const Value& value);

/// Options for the rows of a table.
struct RowOptions {
    bool captions = true; ///< shows the groups' names above them
    /// Rows that are left out, because they are drawn elsewhere.
    std::function<bool(const ParamRow& row)> leavesOut = {};
    /// Rows that are folded, in addition to those that belong to a choice that is not selected.
    std::function<bool(const ParamRow& row)> folds = {};
    /// Called after a group of rows.
    std::function<void(std::string_view group)> after = {};
};

/// Every row of a table: those that may have an effect with these values, group by group, and below them the
/// others, folded.
void paramRows(const Session& session, const Owner& owner, const StructTable& table,
               const RowOptions& options = {});

/// Whether a row's value can have an effect with the values of the others: the slices of a cube cannot.
[[nodiscard]] bool isRelevant(const Session& session, const Owner& owner, const ParamRow& row);

/// A square button; `name` is its name in tests.
bool squareButton(const char* sign, std::string_view name, const Sentence& help, bool enabled);

} // namespace texplorer::ui
