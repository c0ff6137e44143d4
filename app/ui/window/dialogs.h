#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "app/ui/window/file_browser.h"

namespace texplorer::ui {

/// What the dialogs remember.
struct DialogsState {
    FileBrowser browser;
    Dialog browsed = Dialog::None; ///< the dialog that `browser` was prepared for
};

/// The dialog that WindowState::dialog names.
void drawDialogs(Session& session, DialogsState& state, const Pictures& pictures);

} // namespace texplorer::ui
