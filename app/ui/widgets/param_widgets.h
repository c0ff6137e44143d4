#pragma once

#include "app/ui/model/session.h"
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

/// One line: label, control, and a sign to reset it where it differs from the initial value. The control
/// suits the row's kind. Records the edit. True where the value changed.
bool paramWidget(Session& session, const Owner& owner, const ParamRow& row);

/// The control alone, for panels with lines of their own; a right click resets it. True where the value
/// changed.
bool paramControl(Session& session, const Owner& owner, const ParamRow& row, float width);

/// Every row of a table that has an effect on these values, with the row's group as a caption.
void paramRows(Session& session, const Owner& owner, const StructTable& table);

/// Whether a row's value can matter beside the others: the slices of a cube can't.
[[nodiscard]] bool isRelevant(const Session& session, const Owner& owner, const ParamRow& row);

/// A number that one drags, in the current item width, with the colour of its component at its left (-1:
/// none).
bool dragNumber(const char* id, float& value, const Range& range, int component);

/// A button as wide as it is high; `name` is what tests call it.
bool squareButton(const char* label, std::string_view name, std::string_view help, bool enabled);

/// Ends a step of undo when the last widget is let go.
void sealAfterItem(Session& session);

/// A tooltip with wrapped text for the last widget.
void helpTip(std::string_view text);

/// A small dim caption over a group.
void caption(std::string_view text);

} // namespace texplorer::ui
