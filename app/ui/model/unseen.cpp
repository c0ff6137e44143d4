#include "app/ui/model/unseen.h"

#include "app/ui/model/session.h"
#include "app/ui/state/workspace.h"

namespace texplorer::ui {

void restUnseen(Session& session) {
    const auto isSeen = [&](Figure figure) {
        return session.window.figure == figure && isShown(session.settings.workspace, Tab::Figures);
    };
    Services& services = session.services;
    if (!isSeen(Figure::Environments))
        services.environments->rest();
    if (!isSeen(Figure::Sheet))
        services.sheet->rest();
    if (!isShown(session.settings.workspace, Tab::Commands))
        services.programs->rest();
}

} // namespace texplorer::ui
