#include "app/ui/texture_space/plane_look.h"

#include <utility>

namespace texplorer::ui {
namespace {

std::optional<LevelsRequest> requestOf(const Session& session) {
    const Texture* texture = boundTexture(session);
    if (!texture)
        return std::nullopt;
    LevelsRequest request{session.document.images.picturesOf(*texture), imageSettings(*texture),
                          selectedUnit(session).target};
    return request.pictures.base ? std::optional(std::move(request)) : std::nullopt;
}

} // namespace

void LevelPicture::follow(const Session& session, const PlaneLook& look, bool needed) {
    std::optional<LevelsRequest> levels = needed ? requestOf(session) : std::nullopt;
    computing_ = false;
    if (!levels) {
        answer_.reset();
        session.services.levelPictures.rest();
        return;
    }
    const LevelPictureRequest request{*std::move(levels), look.level, look};
    answer_ = session.services.levelPictures.answer(request, session.services.levels);
    computing_ = !answer_ || answer_->request != request;
    // After a change of the image the host's picture is closer than the old one.
    if (answer_ && answer_->request.levels.pictures.base != request.levels.pictures.base)
        answer_.reset();
}

const std::string& LevelPicture::problem() const {
    static const std::string none;
    return answer_ && !computing_ ? answer_->problem : none;
}

std::vector<int> levelsOfBound(const Session& session) {
    const std::optional<LevelsRequest> request = requestOf(session);
    const auto summary = request ? session.services.levels.summary(*request) : nullptr;
    std::vector<int> numbers;
    for (const LevelReport& level : summary ? summary->report.levels : std::vector<LevelReport>{})
        numbers.push_back(level.number);
    return numbers;
}

std::optional<glm::ivec3> firstExtentOfBound(const Session& session) {
    const std::optional<LevelsRequest> request = requestOf(session);
    const auto summary = request ? session.services.levels.summary(*request) : nullptr;
    if (!summary || summary->report.levels.empty())
        return std::nullopt;
    const LevelReport& first = summary->report.levels.front();
    const int border = boundTexture(session)->border != 0 ? 2 : 0; // it belongs to the level
    const Target target = request->target;
    return glm::ivec3(first.width - border, target == Target::Texture1D ? 1 : first.height - border,
                      target == Target::Texture3D ? first.depth - border : 1);
}

} // namespace texplorer::ui
