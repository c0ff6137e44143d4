#include "app/screenshot/workers/work_loop.h"

#include "app/screenshot/workers/message.h"

#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/prctl.h>
#include <sys/socket.h>

namespace texplorer::workers {

void workLoop(int socket, const std::function<std::string(const std::string&)>& work) {
    ::prctl(PR_SET_NAME, "texshot"); // else ps has it as "exe", by the link that it was started by
    Inbox inbox;
    for (;;) {
        std::optional<Message> message = inbox.take();
        if (!message) {
            if (inbox.isBroken() || !inbox.read(socket))
                return;
            continue;
        }
        if (!send(socket, Kind::Begun, {}) || !send(socket, Kind::Answer, work(message->text)))
            return;
    }
}

std::optional<int> workerSocket(int argc, const char* const* argv) {
    if (argc != 3 || std::strcmp(argv[1], workerWord) != 0)
        return std::nullopt;
    int socket = -1;
    const std::string_view text = argv[2];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), socket);
    int type = 0;
    socklen_t size = sizeof type;
    if (error != std::errc() || end != text.data() + text.size() ||
        ::getsockopt(socket, SOL_SOCKET, SO_TYPE, &type, &size) != 0)
        return std::nullopt;              // typed by somebody
    ::fcntl(socket, F_SETFD, FD_CLOEXEC); // what a driver starts must not keep it open
    return socket;
}

} // namespace texplorer::workers
