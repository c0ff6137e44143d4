#include "core/emit/program_worker.h"

#include "core/scene/params/params.h"
#include "core/texture/levels_worker.h"

#include <algorithm>
#include <utility>

namespace texplorer::emit {
namespace {

constexpr FailureWords texelsFailure{"there is no memory for its texels", "its texels can't be made"};

/// A program shows what a unit shows that key frames switch on at times.
Scene withSwitchedUnits(const Scene& scene) {
    Scene shown = scene;
    for (const KeyFrame& key : scene.timeline.keys) {
        const auto at = paramAt(scene, key.path);
        if (at && at->row->member == memberId<&Unit::enabled>)
            static_cast<void>(putBetween(shown, key.path, "true", "true", 0));
    }
    return shown;
}

} // namespace

struct ProgramWorker::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::Queue, texelsFailure, std::move(wake), levels.stop},
              [this](const Making::Task& task) { return work(task); },
              [](const TexelRequest& request, const Error& error) {
                  return Made{request, std::make_shared<const Result<TextureCode>>(fail(error))};
              }) {}

    struct Made {
        TexelRequest request;
        TextureCodes::Code code;
    };
    using Making = Worker<TexelRequest, Made>;

    // Of the thread that asks.
    TextureCodes codes;
    std::vector<TexelRequest> asked; ///< of the thread that works

    const LevelWork levels;
    Making worker; // last: it ends before the rest does

    [[nodiscard]] std::optional<Made> work(const Making::Task& task) const;
    void receive();
    void ask(std::vector<TexelRequest> wanted);
};

std::optional<ProgramWorker::State::Made> ProgramWorker::State::work(const Making::Task& task) const {
    LevelWork how = levels;
    how.stop = task.stop();
    return Made{task.job(), TextureCodes(std::move(how)).of(task.job())};
}

void ProgramWorker::State::receive() {
    for (Made& made : worker.take()) {
        std::erase(asked, made.request);
        codes.keep(std::move(made.request), std::move(made.code));
    }
}

/// Of what was asked for before, what nobody wants any more is given up.
void ProgramWorker::State::ask(std::vector<TexelRequest> wanted) {
    const auto isUnwanted = [&](const TexelRequest& request) {
        return std::ranges::find(wanted, request) == wanted.end();
    };
    if (std::ranges::any_of(asked, isUnwanted))
        worker.drop(isUnwanted);
    for (const TexelRequest& request : wanted) {
        if (std::ranges::find(asked, request) == asked.end())
            worker.ask(request);
    }
    asked = std::move(wanted);
}

ProgramWorker::ProgramWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

ProgramWorker::~ProgramWorker() = default;

std::optional<ProgramWorker::Program> ProgramWorker::program(Flavour flavour, const Scene& scene,
                                                             const ImageSource& images,
                                                             const ProgramOptions& options) {
    State& state = *state_;
    state.receive();
    std::vector<TexelRequest> missing;
    for (std::optional<TexelRequest>& request : texelRequests(withSwitchedUnits(scene), images, options)) {
        if (request && !isQuick(request->levels) && !state.codes.has(*request) &&
            std::ranges::find(missing, *request) == missing.end())
            missing.push_back(*std::move(request));
    }
    state.ask(std::move(missing));
    state.receive(); // what was made at once
    if (!state.asked.empty())
        return std::nullopt;
    Program made = emit::program(flavour, scene, images, options, state.codes);
    state.codes.forgetUnused();
    return made;
}

bool ProgramWorker::isMaking() const {
    return !state_->asked.empty();
}

void ProgramWorker::rest() {
    if (!state_->asked.empty())
        state_->worker.clear();
    state_->asked.clear();
    state_->codes.forgetAll();
}

void ProgramWorker::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::emit
