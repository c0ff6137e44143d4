#pragma once

#include "app/ui/language/catalogue.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/palette.h"

namespace texplorer::ui {

/// What panels and texts are scaled by: the content scale of the monitor, and the size of text that the user
/// has chosen.
[[nodiscard]] float textScale(float contentScale, int textPercent);

/// Sets the current ImGui context up: fonts, colours and metrics, no imgui.ini. Call it once before the first
/// frame, and between two frames when one of the five changes; the host then renews its font texture. The
/// letters of `catalogue`, which may be nullptr, are there afterwards if hasLettersOf its language.
void applyTheme(float contentScale, Theme theme = Theme::Dark, int textPercent = 100,
                const Catalogue* catalogue = nullptr, const Letters& letters = {});

} // namespace texplorer::ui
