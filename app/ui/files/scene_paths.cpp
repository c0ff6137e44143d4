#include "app/ui/files/scene_paths.h"

namespace texplorer::ui {

namespace fs = std::filesystem;

fs::path absolutePath(const fs::path& path) {
    std::error_code failed;
    const fs::path result = fs::absolute(path, failed);
    return failed ? path : result.lexically_normal();
}

std::string nameFrom(const fs::path& directory, const fs::path& file) {
    const fs::path relative = absolutePath(file).lexically_relative(absolutePath(directory));
    const bool below = !relative.empty() && *relative.begin() != "..";
    return below ? relative.generic_string() : absolutePath(file).generic_string();
}

} // namespace texplorer::ui
