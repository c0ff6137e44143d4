#include "app/ui/widgets/program_menu.h"

#include "app/ui/files/program_file.h"
#include "app/ui/widgets/panel_menus.h"
#include "app/ui/widgets/tip.h"

#include <fmt/core.h>

namespace texplorer::ui {

void programMenuItems(const Session& session) {
    for (const EnumRow& row : emit::flavourRows) {
        if (menuItem(row.label))
            act(session, [&row](Session& s) { askSaveProgram(s, static_cast<emit::Flavour>(row.value)); });
        item(fmt::format("menu:{}", row.label), row.help);
    }
}

} // namespace texplorer::ui
