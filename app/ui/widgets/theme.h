#pragma once

#include "app/ui/language/catalogue.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/palette.h"

namespace texplorer::ui {

/// The scale of panels and texts: the content scale of the monitor, and the size of text chosen by the user.
[[nodiscard]] float textScale(float contentScale, int textPercent);

/// Sets up the current ImGui context: fonts, colours and metrics, no imgui.ini. Call it once before the first
/// frame, and between two frames if one of the five arguments changes; the host then updates its font
/// texture. The letters of `catalogue`, which may be nullptr, are available afterwards if hasLettersOf its
/// language.
void applyTheme(float contentScale, Theme theme = Theme::Dark, int textPercent = 100,
                const Catalogue* catalogue = nullptr, const Letters& letters = {});

} // namespace texplorer::ui
