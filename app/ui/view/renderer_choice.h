#pragma once

#include "app/ui/model/session.h"

#include <array>

namespace texplorer::ui {

/// The help of a renderer in this window: what it is, and, if it is not offered, why.
[[nodiscard]] Sentence helpOf(const ViewSettings& settings, const EnumRow& renderer);

/// The size of the choice in the menu bar.
enum class RendererForm {
    Buttons, ///< one button for each, and one to compare
    Brief,   ///< the same with short words
    List,    ///< a menu with the name of the current choice
};
inline constexpr std::array rendererForms{RendererForm::Buttons, RendererForm::Brief, RendererForm::List};

/// In pixels, including the gap before it.
[[nodiscard]] float rendererChoiceWidth(const ViewSettings& settings, RendererForm form);

/// The choice of the renderer in the menu bar. The name of a list is cut if it is wider than `maxWidth`.
void drawRendererChoice(const Session& session, RendererForm form, float maxWidth);

} // namespace texplorer::ui
