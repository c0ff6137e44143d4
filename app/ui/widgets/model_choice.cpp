#include "app/ui/widgets/model_choice.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "texplorer/scene/drawn_models.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {

Sentence shownNameOf(const Model& model) {
    return model.name.empty() ? Sentence(nameOf(model)) : ProperName{model.name};
}

void modelChoice(const Session& session, float minWidth, float maxWidth) {
    const std::vector<Model>& models = presentScene(session).models;
    const auto name = [&](int index) {
        return Sentence("{0}  {1}", index, shownNameOf(models[static_cast<std::size_t>(index)]));
    };
    const Sentence chosen = name(session.look.selection.model);
    const float beside = minWidth - listRoom(minWidth);
    const float width = std::clamp(textWidth(chosen) + beside + 1, minWidth, maxWidth);
    const std::string shown = fitted(chosen, listRoom(width));
    ImGui::SetNextItemWidth(width);
    if (beginCombo("##model", shown.c_str())) {
        for (int i = 0; i < static_cast<int>(models.size()); ++i) {
            if (ImGui::Selectable(tr(name(i)).c_str(), i == session.look.selection.model))
                act(session, [i](Session& changed) {
                    changed.look.selection.model = i;
                    changed.look.selection.vertex.reset();
                });
            noteItem(fmt::format("model:{}", i));
        }
        endCombo();
    }
    noteItem("model choice");
    noteItem("model choice:" + shown);
    const char* help = N_("The model whose values and vertices are shown");
    helpTip(shown == tr(chosen) ? Sentence(help) : Sentence("{0}\n{1}", chosen, help));
}

} // namespace texplorer::ui
