#include "texplorer/emit/program_worker.h"

#include "texplorer/texture/levels_worker.h"

#include <algorithm>
#include <utility>

namespace texplorer::emit {
namespace {

constexpr FailureWords texelsFailure{N_("not enough memory for its texels"), N_("its texels can't be made")};
constexpr FailureWords programFailure{N_("not enough memory for the program"),
                                      N_("the program can't be written")};

/// Whether the program of a scene is written in a few milliseconds: without large meshes.
bool isQuickToWrite(const Scene& scene) {
    constexpr std::size_t maxVertices = 4096;
    std::size_t vertices = 0;
    for (const Model& model : scene.models)
        vertices += model.mesh.positions.size();
    return vertices <= maxVertices;
}

} // namespace

struct ProgramWorker::State {
    State(When when, const std::function<void()>& wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::Queue, texelsFailure, wake, levels.stop},
              [this](const Making::Task& task) { return work(task); },
              [](const TexelRequest& request, const Error& error) {
                  return Made{request, std::make_shared<const Result<TextureCode>>(fail(error))};
              })
        , writer(
              {when, JobOrder::NewestWins, programFailure, wake, levels.stop},
              [](const Writing::Task& task) { return write(task); },
              [](const ProgramRequest& request, const Error& error) {
                  return Written{request.wanted, fail(error)};
              }) {}

    struct Made {
        TexelRequest request;
        TextureCodes::Code code;
    };
    using Making = Worker<TexelRequest, Made>;

    struct Wanted {
        Flavour flavour;
        Scene scene;
        ImageSource images;

        bool operator==(const Wanted&) const = default;
    };
    struct ProgramRequest {
        Wanted wanted;
        ProgramOptions options;
        TextureCodes codes;
    };
    struct Written {
        Wanted wanted;
        Program program;
    };
    using Writing = Worker<ProgramRequest, Written>;

    // Of the thread that asks.
    std::optional<Wanted> wanted;   ///< of the thread that writes
    std::optional<Program> written; ///< what came of it
    TextureCodes codes;
    std::vector<TexelRequest> asked; ///< of the thread that works

    const LevelWork levels;
    Making worker; // last: they end before the rest does
    Writing writer;

    [[nodiscard]] std::optional<Made> work(const Making::Task& task) const;
    [[nodiscard]] static std::optional<Written> write(const Writing::Task& task);
    void receive();
    void ask(std::vector<TexelRequest> missing);
    [[nodiscard]] std::optional<Program> writtenBeside(Wanted now, const ProgramOptions& options);
    void forgetProgram();
};

std::optional<ProgramWorker::State::Made> ProgramWorker::State::work(const Making::Task& task) const {
    LevelWork how = levels;
    how.stop = task.stop();
    return Made{task.job(), TextureCodes(std::move(how)).of(task.job())};
}

std::optional<ProgramWorker::State::Written> ProgramWorker::State::write(const Writing::Task& task) {
    if (task.superseded().stop_requested())
        return std::nullopt;
    const auto& [wanted, options, known] = task.job();
    TextureCodes codes = known;
    return Written{wanted, emit::program(wanted.flavour, wanted.scene, wanted.images, options, codes)};
}

void ProgramWorker::State::receive() {
    for (Made& made : worker.take()) {
        std::erase(asked, made.request);
        codes.keep(std::move(made.request), std::move(made.code));
    }
    for (Written& each : writer.take()) {
        if (wanted == each.wanted)
            written = std::move(each.program);
    }
}

void ProgramWorker::State::forgetProgram() {
    if (wanted)
        writer.clear();
    wanted.reset();
    written.reset();
}

std::optional<ProgramWorker::Program> ProgramWorker::State::writtenBeside(Wanted now,
                                                                          const ProgramOptions& options) {
    if (wanted != now) {
        wanted = std::move(now);
        written.reset();
        writer.ask({*wanted, options, codes});
        receive(); // what was written at once
    }
    return written;
}

/// Of what was asked for before, what nobody wants any more is given up.
void ProgramWorker::State::ask(std::vector<TexelRequest> missing) {
    const auto isUnwanted = [&](const TexelRequest& request) {
        return std::ranges::find(missing, request) == missing.end();
    };
    if (std::ranges::any_of(asked, isUnwanted))
        worker.drop(isUnwanted);
    for (const TexelRequest& request : missing) {
        if (std::ranges::find(asked, request) == asked.end())
            worker.ask(request);
    }
    asked = std::move(missing);
}

ProgramWorker::ProgramWorker(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, wake, std::move(levels))) {}

ProgramWorker::~ProgramWorker() = default;

std::optional<ProgramWorker::Program> ProgramWorker::program(Flavour flavour, const Scene& scene,
                                                             const ImageSource& images,
                                                             const ProgramOptions& options) {
    State& state = *state_;
    state.receive();
    std::vector<TexelRequest> missing;
    for (std::optional<TexelRequest>& request : texelRequests(flavour, scene, images, options)) {
        if (!request || isQuick(request->levels))
            continue;
        if (state.codes.has(*request))
            static_cast<void>(state.codes.of(*request)); // it is still used
        else if (std::ranges::find(missing, *request) == missing.end())
            missing.push_back(*std::move(request));
    }
    state.ask(std::move(missing));
    state.receive(); // what was made at once
    if (!state.asked.empty()) {
        state.forgetProgram();
        return std::nullopt;
    }
    std::optional<Program> made;
    if (isQuickToWrite(scene)) {
        state.forgetProgram();
        made = emit::program(flavour, scene, images, options, state.codes);
    } else {
        made = state.writtenBeside({flavour, scene, images}, options);
    }
    state.codes.forgetUnused();
    return made;
}

bool ProgramWorker::isMaking() const {
    return !state_->asked.empty() || (state_->wanted && !state_->written);
}

void ProgramWorker::rest() {
    state_->forgetProgram();
    if (!state_->asked.empty())
        state_->worker.clear();
    state_->asked.clear();
    state_->codes.forgetAll();
}

void ProgramWorker::wait() const {
    state_->worker.wait();
    state_->writer.wait();
}

} // namespace texplorer::emit
