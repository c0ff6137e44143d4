#include "app/ui/parameters/unit_section.h"

#include "app/ui/parameters/environment_line.h"
#include "app/ui/parameters/shown_structs.h"
#include "core/scene/params/keys.h"

namespace texplorer::ui {

void unitSection(const Session& session) {
    const std::string_view environment = findParam(unitTable(), keyOf<&Unit::envMode>())->group;
    RowOptions options;
    // The texture is chosen by its name, in the place where it is edited.
    options.leavesOut = [](const ParamRow& row) { return row.member == memberId<&Unit::texture>; };
    options.after = [&](std::string_view group) {
        if (group == environment)
            environmentLine(session);
    };
    paramRows(session, unitOwner(session), unitTable(), options);
}

} // namespace texplorer::ui
