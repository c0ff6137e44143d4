#include "app/ui/texture_space/plane_look.h"

#include "app/ui/model/level_view.h"

#include <algorithm>
#include <tuple>

namespace texplorer::ui {
void LevelPicture::follow(const Session& session, const PlaneLook& look, bool needed) {
    ask(session, [this, &look, needed](Session& changed) {
        const std::tuple before(picture(), problem(), computing_);
        LevelPictures& maker = workers(changed).levelPictures;
        if (const auto levels = needed ? boundLevels(changed) : std::nullopt) {
            const LevelPictureRequest request{*levels, look.level, look};
            answer_ = maker.answer(request, workers(changed).levels);
            computing_ = !answer_ || answer_->request != request;
            // After a change of the image the host's picture is closer than the old one.
            if (answer_ && answer_->request.levels.pictures.base != request.levels.pictures.base)
                answer_.reset();
        } else {
            answer_.reset();
            computing_ = false;
            maker.rest();
        }
        return before != std::tuple(picture(), problem(), computing_);
    });
}

const Sentence& LevelPicture::problem() const {
    static const Sentence none;
    return answer_ && !computing_ ? answer_->problem : none;
}

std::vector<LevelReport> levelsOfBound(const Session& session) {
    const std::optional<LevelsRequest> request = boundLevels(session);
    const auto summary = request ? summaryOf(session, *request) : nullptr;
    return summary ? summary->report.levels : std::vector<LevelReport>{};
}

std::optional<glm::ivec3> extentOfBound(const Session& session, std::optional<int> level) {
    const std::vector<LevelReport> levels = levelsOfBound(session);
    const auto found = level ? std::ranges::find(levels, *level, &LevelReport::number) : levels.begin();
    if (found == levels.end())
        return std::nullopt;
    const int border = boundTexture(session)->border != 0 ? 2 : 0; // it belongs to the level
    const Target target = selectedUnit(session).target;
    return glm::ivec3(found->width - border, target == Target::Texture1D ? 1 : found->height - border,
                      target == Target::Texture3D ? found->depth - border : 1);
}

} // namespace texplorer::ui
