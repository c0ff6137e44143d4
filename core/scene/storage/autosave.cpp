#include "texplorer/scene/storage/autosave.h"

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

namespace texplorer {

/// What could not be written is tried again then, be it edited or not.
constexpr double untilRetry = 10; // seconds

struct Autosave::State {
    std::filesystem::path folder;
    std::function<void()> wake;
    double delay = 0; // seconds
    Clock clock;

    std::mutex mutex; // of what follows
    std::condition_variable_any news;
    std::optional<UnsavedScene> told; ///< what was told last; nothing: there is nothing to lose
    std::optional<double> due;        ///< when it has to be written; nothing: it is
    std::optional<Error> problem;
    Result<void> last{}; ///< of writing; its error was said

    std::mutex writing; // of the place: taken before `mutex`
    UnsavedPlace place;

    std::jthread thread; // the last: it ends first

    void work(const std::stop_token& stop);
    void note(const std::filesystem::path& file, const std::filesystem::path& base, const Scene& scene,
              const std::string& fileHash);
    void writeWhereNobodyElseDoes();
    Result<void> write();
    Result<void> writeAlone(bool& hasProblem);
    Result<void> put(const UnsavedScene& draft);
};

Autosave::Autosave(std::filesystem::path folder, std::function<void()> wake, std::chrono::milliseconds delay,
                   Clock clock)
    : state_(std::make_unique<State>()) {
    state_->folder = std::move(folder);
    state_->wake = std::move(wake);
    state_->delay = std::chrono::duration<double>(delay).count();
    state_->clock = std::move(clock);
    try {
        // Not through `state_`: a move can leave it empty before the thread has started.
        state_->thread =
            std::jthread([state = state_.get()](const std::stop_token& stop) { state->work(stop); });
    } catch (const std::system_error&) { // no thread available: the next call writes what is due
    }
}

Autosave::~Autosave() = default;

void Autosave::State::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        {
            std::unique_lock lock(mutex);
            if (!due) {
                news.wait(lock, stop, [this] { return due.has_value(); });
                continue;
            }
            // What is told meanwhile goes with it; only a request to forget is earlier.
            const double then = *due;
            const auto left =
                std::chrono::ceil<std::chrono::microseconds>(std::chrono::duration<double>(then - clock()));
            if (news.wait_for(lock, stop, left, [&] { return !due || *due < then; }) || stop.stop_requested())
                continue;
        }
        (void)write();
    }
}

void Autosave::State::writeWhereNobodyElseDoes() {
    if (thread.joinable())
        return;
    {
        const std::scoped_lock lock(mutex);
        if (!due || clock() < *due)
            return;
    }
    (void)write();
}

Result<void> Autosave::State::put(const UnsavedScene& draft) {
    if (place.isOpen() && place.write(draft))
        return {};
    Result<UnsavedPlace> made =
        UnsavedPlace::create(folder); // the first one, or the folder has been swept away
    if (!made)
        return fail(made.error());
    place = std::move(*made);
    return place.write(draft);
}

Result<void> Autosave::State::write() {
    bool hasProblem = false;
    Result<void> written = writeAlone(hasProblem);
    if (hasProblem && wake)
        wake(); // without a lock: where that finds the display gone, what is left is written
    return written;
}

Result<void> Autosave::State::writeAlone(bool& hasProblem) {
    const std::scoped_lock one(writing);
    std::optional<UnsavedScene> draft;
    {
        const std::scoped_lock lock(mutex);
        if (!due)
            return last;
        due.reset();
        draft = told;
    }
    if (!draft) {
        place.remove();
        const std::scoped_lock lock(mutex);
        return last = {}; // the work that could not be written is not needed any more
    }
    Result<void> written = put(*draft);
    const std::scoped_lock lock(mutex);
    if (!written && last)
        problem = written.error();
    last = written;
    if (!written && !due)
        due = clock() + untilRetry;
    hasProblem = problem.has_value();
    return written;
}

void Autosave::keep(const std::filesystem::path& file, const std::filesystem::path& folder,
                    const Scene& scene, const std::string& fileHash) {
    state_->note(file, folder, scene, fileHash);
    state_->writeWhereNobodyElseDoes();
}

void Autosave::State::note(const std::filesystem::path& file, const std::filesystem::path& base,
                           const Scene& scene, const std::string& fileHash) {
    const std::scoped_lock lock(mutex);
    if (told && told->scene == scene && told->file == file && told->folder == base &&
        told->fileHash == fileHash)
        return;
    told = UnsavedScene{file, base, scene, fileHash};
    const double then = clock() + delay;
    if (!due || then < *due) {
        due = then;
        news.notify_all();
    }
}

void Autosave::adopt(UnsavedPlace place, UnsavedScene told) {
    if (!place.isOpen())
        return keep(told.file, told.folder, told.scene);
    const std::scoped_lock one(state_->writing);
    const std::scoped_lock lock(state_->mutex);
    state_->place.remove();
    state_->place = std::move(place);
    state_->told = std::move(told);
    state_->due.reset();
    state_->last = {};
}

void Autosave::forget() {
    {
        const std::scoped_lock lock(state_->mutex);
        if (!state_->told)
            return;
        state_->told.reset();
        state_->due = state_->clock();
        state_->news.notify_all();
    }
    state_->writeWhereNobodyElseDoes();
}

Result<void> Autosave::flush() {
    return state_->write();
}

std::optional<double> Autosave::due() const {
    if (state_->thread.joinable())
        return std::nullopt;
    const std::scoped_lock lock(state_->mutex);
    return state_->due;
}

std::optional<Error> Autosave::takeProblem() {
    const std::scoped_lock lock(state_->mutex);
    return std::exchange(state_->problem, std::nullopt);
}

const std::filesystem::path& Autosave::folder() const {
    return state_->folder;
}

} // namespace texplorer
