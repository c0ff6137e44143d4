#include "texplorer/reference/probe_worker.h"

#include "texplorer/reference/probe.h"
#include "texplorer/reference/renderer_worker.h"

#include <utility>

namespace texplorer::reference {

namespace {

constexpr FailureWords probingFailure{N_("not enough memory for the answer"),
                                      N_("the pixel can't be explained")};

std::shared_ptr<const ProbeWorker::Answer> answerProbe(ReferenceRenderer& renderer, const ProbeRequest& asked,
                                                       const DrawOptions& options) {
    auto made = std::make_shared<ProbeWorker::Answer>();
    made->request = asked;
    if (asked.pixel)
        made->explanation =
            tried(probingFailure, [&] { return renderer.probe(asked.picture, *asked.pixel, options); });
    if (asked.texel)
        made->contributions = tried(
            probingFailure, [&] { return renderer.contributions(asked.picture, *asked.texel, options); });
    return made;
}

} // namespace

struct ProbeWorker::State {
    RendererWorker<ProbeRequest, Answer> worker;
};

ProbeWorker::ProbeWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(new State{{when, probingFailure, std::move(wake), std::move(levels), answerProbe}}) {}

ProbeWorker::~ProbeWorker() = default;

std::shared_ptr<const ProbeWorker::Answer> ProbeWorker::answer(const ProbeRequest& request) {
    // What takes long is to make levels and to find a texel's pixels. The rest is soon done, and while a
    // scene moves it should be, or the user would see nothing of either.
    return state_->worker.answer(request, [&](const ProbeRequest& earlier) {
        return !sameLevels(earlier.picture, request.picture) ||
               (earlier.texel && earlier.texel != request.texel);
    });
}

void ProbeWorker::rest() {
    state_->worker.rest();
}

void ProbeWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::reference
