#include "texplorer/base/thrown.h"

#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace texplorer {
namespace {

const char* endingProgram = "";

[[noreturn]] void sayAndEnd() {
    std::fprintf(stderr, "%s: %.*s\n", endingProgram, static_cast<int>(ownMistake.size()), ownMistake.data());
    std::abort();
}

} // namespace

std::string reasonOf(const std::exception& thrown) {
    if (const auto* system = dynamic_cast<const std::system_error*>(&thrown))
        return system->code().message();
    return std::string(ownMistake);
}

void sayWhatNothingCatches(const char* program) {
    endingProgram = program;
    std::set_terminate(sayAndEnd);
}

} // namespace texplorer
