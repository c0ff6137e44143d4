#include "texplorer/files/descriptor.h"
#include "texplorer/files/folder_events.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <map>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace texplorer {

namespace {

/// Reads all waiting events, so that the next poll blocks.
void drain(const Descriptor& from) {
    std::array<char, 4096> rubbish{};
    while (::read(from.get(), rubbish.data(), rubbish.size()) > 0) {
    }
}

} // namespace

struct FolderEvents::State {
    Descriptor inotify{::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)};
    Descriptor bell{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)};
    std::map<std::filesystem::path, int> folders; // to inotify's numbers
};

FolderEvents::FolderEvents()
    : state_(std::make_unique<State>()) {}

FolderEvents::~FolderEvents() = default;

bool FolderEvents::watch(const std::set<std::filesystem::path>& folders) {
    constexpr std::uint32_t events =
        IN_CLOSE_WRITE | IN_MODIFY | IN_MOVED_TO | IN_CREATE | IN_ATTRIB | IN_ONLYDIR;
    std::erase_if(state_->folders, [&](const auto& entry) {
        if (folders.contains(entry.first))
            return false;
        if (entry.second >= 0)
            (void)::inotify_rm_watch(state_->inotify.get(), entry.second);
        return true;
    });
    // Once more for those that are known, too: two spellings of one folder share a number, and the other one
    // may just have gone.
    bool all = true;
    for (const std::filesystem::path& folder : folders) {
        int& number = state_->folders[folder];
        number =
            state_->inotify.valid() ? ::inotify_add_watch(state_->inotify.get(), folder.c_str(), events) : -1;
        all = all && number >= 0;
    }
    return all;
}

FolderEvents::Reason FolderEvents::wait(int milliseconds) {
    std::array<pollfd, 2> sources{pollfd{state_->bell.get(), POLLIN, 0},
                                  pollfd{state_->inotify.get(), POLLIN, 0}};
    const int ready = ::poll(sources.data(), sources.size(), milliseconds);
    if (ready < 0 && errno != EINTR)
        return Reason::Failed;
    drain(state_->bell);
    if ((sources[1].revents & POLLIN) != 0) {
        drain(state_->inotify); // which file it was, the caller has to see
        return Reason::Happened;
    }
    return ready == 0 ? Reason::Quiet : Reason::Rang;
}

void FolderEvents::ring() noexcept {
    if (state_->bell.valid())
        (void)::eventfd_write(state_->bell.get(), 1);
}

} // namespace texplorer
