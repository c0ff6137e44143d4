#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// What the driver stores of the bound texture; nullptr: OpenGL draws no picture of it.
[[nodiscard]] const view::StoredTexture* storedOf(const Session& session, const Pictures& pictures);
/// view::storedText with the window's groups of digits.
[[nodiscard]] Sentence storedLevelText(const view::StoredLevel& level);

void drawMemoryTab(const Session& session, const Pictures& pictures);

} // namespace texplorer::ui
