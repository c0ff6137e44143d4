#include "texplorer/files/folder_events.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace texplorer {

struct FolderEvents::State {
    std::mutex mutex;
    std::condition_variable bell;
    bool rung = false;
};

FolderEvents::FolderEvents()
    : state_(std::make_unique<State>()) {}

FolderEvents::~FolderEvents() = default;

bool FolderEvents::watch(const std::set<std::filesystem::path>& folders) {
    return folders.empty();
}

FolderEvents::Reason FolderEvents::wait(int milliseconds) {
    std::unique_lock lock(state_->mutex);
    const auto isRung = [this] { return state_->rung; };
    if (milliseconds == forever)
        state_->bell.wait(lock, isRung);
    else
        state_->bell.wait_for(lock, std::chrono::milliseconds(milliseconds), isRung);
    return std::exchange(state_->rung, false) ? Reason::Rang : Reason::Quiet;
}

void FolderEvents::ring() noexcept {
    {
        const std::scoped_lock lock(state_->mutex);
        state_->rung = true;
    }
    state_->bell.notify_one();
}

} // namespace texplorer
