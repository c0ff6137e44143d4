#include "app/ui/widgets/program_menu.h"

#include "app/ui/files/program_file.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

namespace texplorer::ui {

void programMenuItems(const Session& session) {
    for (const EnumRow& row : emit::flavourRows) {
        if (ImGui::MenuItem(label(row.label).c_str()))
            act(session, [&row](Session& s) { askSaveProgram(s, static_cast<emit::Flavour>(row.value)); });
        noteItem(fmt::format("menu:{}", row.label));
        helpTip(std::string(row.help));
    }
}

} // namespace texplorer::ui
