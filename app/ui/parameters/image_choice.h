#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The built-in patterns as small pictures, next to them the texture's previous image file, and a button that
/// opens one. For the bound texture, which must exist.
void imageChoice(const Session& session, const Pictures& pictures);

} // namespace texplorer::ui
