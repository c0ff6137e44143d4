#include "app/ui/widgets/model_choice.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/param_widgets.h"
#include "core/scene/drawn_models.h"

#include <fmt/core.h>

namespace texplorer::ui {

std::string shownNameOf(const Model& model) {
    return model.name.empty() ? tr(nameOf(model)) : model.name;
}

void modelChoice(Session& session, float width) {
    const std::vector<Model>& models = session.document.scene.models;
    const auto name = [&](int index) {
        return fmt::format("{}  {}", index, shownNameOf(models[static_cast<std::size_t>(index)]));
    };
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##model", name(session.window.selection.model).c_str())) {
        for (int i = 0; i < static_cast<int>(models.size()); ++i) {
            if (ImGui::Selectable(name(i).c_str(), i == session.window.selection.model)) {
                session.window.selection.model = i;
                session.window.selection.vertex.reset();
            }
            noteItem(fmt::format("model:{}", i));
        }
        ImGui::EndCombo();
    }
    noteItem("model choice");
    helpTip("Which model's values and vertices are shown");
}

} // namespace texplorer::ui
