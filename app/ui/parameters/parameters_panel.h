#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <string>

namespace texplorer::ui {

/// What the panel remembers.
struct ParametersState {
    ParameterTab tab = ParameterTab::Essentials; ///< in front
    std::string search; ///< what is looked for; its results are shown in the place of the tab
};

void drawParametersPanel(Session& session, ParametersState& state, const Pictures& pictures,
                         const Layout& layout);

} // namespace texplorer::ui
