#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/param_widgets.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// A struct whose rows the parameters show.
struct ShownStruct {
    Section section;
    std::string title; ///< "Generated s", where its section has several
    Owner owner;
    const StructTable* table;
};

/// All of what is selected, in the order of the tabs. They hold until the next edit of a list of the scene.
[[nodiscard]] std::vector<ShownStruct> shownStructs(Session& session);

/// Whether an edit of the row may add elements to the scene's lists, so that the owners are no longer there.
[[nodiscard]] bool mayMoveLists(const ParamRow& row);

/// The structs that panels edit by their rows, as one edits them.
[[nodiscard]] Owner textureOwner(Session& session); ///< of the bound one, which there must be
[[nodiscard]] Owner unitOwner(Session& session);
[[nodiscard]] Owner materialOwner(Session& session);

} // namespace texplorer::ui
