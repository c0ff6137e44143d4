#include "app/ui/services/free_name.h"

#include "texplorer/files/file_io.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

bool isFree(const fs::path& file) {
    std::error_code ignored;
    return !fs::exists(fs::symlink_status(file, ignored));
}

} // namespace

Result<fs::path> writeFreely(const fs::path& wanted, ByteView bytes,
                             const std::optional<FileFingerprint>& replaces) {
    fs::path file = wanted;
    for (int number = 2;; ++number) {
        const Result<bool> written = writeFileIf(
            file, bytes, [&] { return isFree(file) || (replaces && fingerprintOf(file) == replaces); });
        if (!written)
            return fail(written.error());
        if (*written)
            return file;
        file = wanted.parent_path() /
               fmt::format("{}-{}{}", wanted.stem().string(), number, wanted.extension().string());
    }
}

} // namespace texplorer::ui
