#pragma once

#include "app/ui/model/view_settings.h"

#include <string>

namespace texplorer::ui {

/// What a row of RendererKind says in this window: what it is, and where it isn't offered why.
[[nodiscard]] std::string helpOf(const ViewSettings& settings, const EnumRow& renderer);

/// Who draws the picture, in the menu bar; nothing where `available` is too narrow.
void drawRendererChoice(ViewSettings& settings, float available);

} // namespace texplorer::ui
