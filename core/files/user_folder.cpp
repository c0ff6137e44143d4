#include "texplorer/files/user_folder.h"

#include <cstdlib>

namespace texplorer {
namespace {

/// Relative paths are to be ignored, says the specification.
std::filesystem::path absoluteIn(const char* variable) {
    const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): it is not changed
    std::filesystem::path path = value == nullptr ? "" : value;
    return path.is_absolute() ? path : std::filesystem::path();
}

} // namespace

std::filesystem::path userFolder(const char* variable, const char* belowHome) {
    if (std::filesystem::path named = absoluteIn(variable); !named.empty())
        return named;
    const std::filesystem::path home = absoluteIn("HOME");
    return home.empty() ? home : home / belowHome;
}

} // namespace texplorer
