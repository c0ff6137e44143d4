#include "app/ui/window/presets_menu.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/preset_edits.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

namespace texplorer::ui {

void drawPresetsMenu(const Session& session) {
    std::string_view group;
    for (const Preset& preset : presets()) {
        if (preset.group != group) {
            group = preset.group;
            caption(group);
        }
        if (ImGui::MenuItem(label(preset.label).c_str()))
            choosePreset(session, preset);
        noteItem(fmt::format("preset:{}", preset.name));
        if (ImGui::IsItemHovered())
            previewPreset(session, preset);
        helpTip(fmt::format("{}\n{}", preset.help, preset.look));
    }
}

} // namespace texplorer::ui
