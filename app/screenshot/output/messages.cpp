#include "app/screenshot/output/messages.h"

#include "app/screenshot/command.h"

namespace texplorer::screenshot {

Loudness& loudness() {
    static Loudness ours;
    return ours;
}

void warn(const Error& note) {
    if (!loudness().quiet)
        static_cast<void>(complain(note));
}

void tell(const std::string& deed) {
    if (loudness().verbose)
        static_cast<void>(complain({ErrorCode::Cancelled, deed, {}}));
}

} // namespace texplorer::screenshot
