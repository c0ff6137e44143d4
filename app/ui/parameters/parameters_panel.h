#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/pictures.h"

#include <string>

namespace texplorer::ui {

/// The state of the panel.
struct ParametersState {
    ParameterTab tab = ParameterTab::Essentials; ///< in front
    std::string search; ///< the search text; its results are shown instead of the tab
};

void drawParametersPanel(const Session& session, ParametersState& state, const Pictures& pictures,
                         const Layout& layout);

} // namespace texplorer::ui
