#include "texplorer/reference/level_map_worker.h"

#include "texplorer/reference/renderer_worker.h"

#include <utility>

namespace texplorer::reference {

namespace {

constexpr FailureWords mappingFailure{N_("not enough memory for the levels of the pixels"),
                                      N_("the levels of the pixels can't be computed")};

std::shared_ptr<const LevelMapWorker::Answer>
mapLevels(ReferenceRenderer& renderer, const LevelMapRequest& asked, const DrawOptions& options) {
    Result<LevelMap> map =
        tried(mappingFailure, [&] { return renderer.levels(asked.picture, asked.unit, options); });
    if (!map && map.error().code == ErrorCode::Cancelled)
        return nullptr;
    auto made = std::make_shared<LevelMapWorker::Answer>(LevelMapWorker::Answer{asked, std::move(map)});
    if (made->map && asked.shown != Shown::Picture)
        made->colors = std::make_shared<const Image>(falseColors(*made->map, asked.shown));
    return made;
}

} // namespace

struct LevelMapWorker::State {
    RendererWorker<LevelMapRequest, Answer> worker;
};

LevelMapWorker::LevelMapWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(new State{{when, mappingFailure, std::move(wake), std::move(levels), mapLevels}}) {}

LevelMapWorker::~LevelMapWorker() = default;

std::shared_ptr<const LevelMapWorker::Answer> LevelMapWorker::answer(const LevelMapRequest& request) {
    return state_->worker.answer(request, [&](const LevelMapRequest& earlier) {
        return !sameLevels(earlier.picture, request.picture);
    });
}

void LevelMapWorker::rest() {
    state_->worker.rest();
}

void LevelMapWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::reference
