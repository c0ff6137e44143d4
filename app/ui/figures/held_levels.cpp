#include "app/ui/figures/held_levels.h"

#include <utility>

namespace texplorer::ui {

void giveLevelsBack(LevelsWorker& worker, HeldLevels& held) {
    if (held.levels && held.request)
        worker.uploaded(*held.request, std::exchange(held.levels, nullptr), {});
    held.levels.reset();
    held.request.reset();
}

bool followLevels(LevelsWorker& worker, HeldLevels& held, std::optional<LevelsRequest> wanted) {
    held.problem = {};
    if (!wanted) {
        held.problem = N_("The image is not loaded.");
        giveLevelsBack(worker, held);
        return true;
    }
    const bool isNew = !held.levels || held.request != wanted;
    if (isNew) {
        std::shared_ptr<const PreparedLevels> levels = worker.prepare(*wanted);
        const bool cancelled = levels && !*levels && levels->error().code == ErrorCode::Cancelled;
        if (!levels || cancelled) {
            held.problem = cancelled ? levels->error().message : Sentence("The levels are being made…");
            return false;
        }
        giveLevelsBack(worker, held);
        held.levels = std::move(levels);
        held.request = std::move(wanted);
    }
    if (!*held.levels)
        held.problem = held.levels->error().message;
    else if ((*held.levels)->levels.empty())
        held.problem = N_("There is no level.");
    return isNew;
}

} // namespace texplorer::ui
