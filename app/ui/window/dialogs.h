#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "app/ui/window/file_browser.h"

namespace texplorer::ui {

/// The state of the dialogs.
struct DialogsState {
    FileBrowser browser;
    Dialog browsed = Dialog::None; ///< the dialog that `browser` was prepared for
};

/// Draws the dialog Asking::dialog.
void drawDialogs(const Session& session, DialogsState& state, const Pictures& pictures);

} // namespace texplorer::ui
