#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The built-in patterns as small pictures, beside them the image file that the texture had, and a button
/// that opens one. Of the bound texture, which there must be.
void imageChoice(Session& session, const Pictures& pictures);

} // namespace texplorer::ui
