#pragma once

#include "app/ui/model/view_settings.h"

#include <array>
#include <string>

namespace texplorer::ui {

/// What a row of RendererKind says in this window: what it is, and where it isn't offered why.
[[nodiscard]] std::string helpOf(const ViewSettings& settings, const EnumRow& renderer);

/// How much room the choice has in the menu bar.
enum class RendererForm {
    Buttons, ///< one for each, and one to compare
    Brief,   ///< the same with short words
    List,    ///< a menu that is called like what is chosen
};
constexpr std::array rendererForms{RendererForm::Buttons, RendererForm::Brief, RendererForm::List};

/// In pixels, with the gap before it.
[[nodiscard]] float rendererChoiceWidth(const ViewSettings& settings, RendererForm form);

/// Who draws the picture, in the menu bar. The name of a list is cut where it is wider than `most`.
void drawRendererChoice(ViewSettings& settings, RendererForm form, float most);

} // namespace texplorer::ui
