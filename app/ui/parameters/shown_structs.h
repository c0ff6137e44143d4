#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/param_widgets.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// A struct whose rows the parameters show.
struct ShownStruct {
    Section section;
    std::string title; ///< "Generated s", if its section has several
    Owner owner;
    const StructTable* table;
};

/// All structs of the selection, in the order of the tabs. Valid until the next edit of a list in the scene.
[[nodiscard]] std::vector<ShownStruct> shownStructs(const Session& session);

/// The structs that panels edit by their rows.
[[nodiscard]] Owner textureOwner(const Session& session); ///< of the bound one, which there must be
[[nodiscard]] Owner unitOwner(const Session& session);
[[nodiscard]] Owner materialOwner(const Session& session);

} // namespace texplorer::ui
