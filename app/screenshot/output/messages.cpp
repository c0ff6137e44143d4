#include "app/screenshot/output/messages.h"

#include "texplorer/text/printable.h"

#include <cstdio>

namespace texplorer::screenshot {

Loudness& loudness() {
    static Loudness ours;
    return ours;
}

void say(const Error& sentence) {
    std::fprintf(stderr, "texshot: %s\n", printable(describe(sentence)).c_str());
}

void warn(const Error& note) {
    if (!loudness().quiet)
        say(note);
}

void tell(const std::string& deed) {
    if (loudness().verbose)
        say({ErrorCode::Cancelled, deed, {}});
}

} // namespace texplorer::screenshot
