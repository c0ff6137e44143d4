#include "app/screenshot/workers/signal_text.h"

#include <fmt/core.h>

#include <cctype>
#include <cstring>

namespace texplorer::workers {

std::string signalText(int signal) {
    const char* name = ::sigabbrev_np(signal);
    const char* meaning = ::sigdescr_np(signal);
    if (name == nullptr || meaning == nullptr)
        return fmt::format("signal {}", signal);
    std::string text = meaning;
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return fmt::format("SIG{}, {}", name, text);
}

} // namespace texplorer::workers
