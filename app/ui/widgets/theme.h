#pragma once

#include "app/ui/language/catalogue.h"
#include "app/ui/state/settings.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/palette.h"

namespace texplorer::ui {

/// The scale of panels and texts: the content scale of the monitor, and the size of text chosen by the user.
[[nodiscard]] float textScale(float contentScale, int textPercent);

/// What the theme takes from the settings.
struct Appearance {
    Theme theme = Theme::Dark;
    int textPercent = 100;
    bool largeControls = false;

    bool operator==(const Appearance&) const = default;
};
[[nodiscard]] Appearance appearanceOf(const Settings& settings);

/// Sets up the current ImGui context: fonts, colours and metrics, no imgui.ini. Call it once before the first
/// frame, and between two frames if one of the four arguments changes; the host then updates its font
/// texture. The letters of `catalogue`, which may be nullptr, are available afterwards if hasLettersOf its
/// language.
void applyTheme(float contentScale, const Appearance& appearance = {}, const Catalogue* catalogue = nullptr,
                const Letters& letters = {});

/// The least height, in pixels, of what a finger is to press. 0: controls are small.
[[nodiscard]] float targetHeight();
/// The same for the width of what is in a row with others.
[[nodiscard]] inline float targetWidth() {
    return targetHeight() * 0.7F;
}

} // namespace texplorer::ui
