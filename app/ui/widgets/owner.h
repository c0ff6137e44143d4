#pragma once

#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <functional>
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

} // namespace texplorer::ui
