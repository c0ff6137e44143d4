#include "app/screenshot/arguments/outputs_apart.h"

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/output/output.h"
#include "texplorer/files/file_fingerprint.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sys/stat.h>
#include <utility>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

using FileId = std::pair<std::uint64_t, std::uint64_t>;

/// Of a regular file, the same under all of its names.
std::optional<FileId> idOf(const std::string& path) {
    const std::optional<FileFingerprint> found = fingerprintOf(path);
    return found ? std::optional(FileId{found->device, found->inode}) : std::nullopt;
}

/// What any number of outputs may go into: /dev/null.
bool isCharacterDevice(const std::string& path) {
    struct stat info = {};
    return ::stat(path.c_str(), &info) == 0 && S_ISCHR(info.st_mode);
}

/// Where files are, whether they exist or not, without links on the way.
class Places {
public:
    fs::path of(const fs::path& path) {
        std::error_code ignored;
        const fs::path name = path.filename();
        if (name.empty() || name == "." || name == ".." || fs::is_symlink(path, ignored))
            return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
        const auto [folder, isNew] = folders_.try_emplace(path.parent_path());
        if (isNew)
            folder->second = fs::weakly_canonical(fs::absolute(folder->first, ignored), ignored);
        return folder->second / name;
    }

private:
    std::map<fs::path, fs::path> folders_; // of many files in one
};

bool isWithin(const fs::path& path, const fs::path& folder) {
    return std::ranges::mismatch(folder, path).in1 == folder.end();
}

tl::unexpected<Error> takesThePlaceOf(const NamedOutput& other, const NamedOutput& output) {
    return fail(ErrorCode::OutOfRange,
                std::string_view(other.option) == output.option
                    ? Sentence("expected a file other than {0}, which is also written", inQuotes(other.path))
                    : Sentence("expected a file other than that of {0}", other.option),
                atOption(output.option));
}

/// Outputs and inputs that lie in a folder which another output fills.
Result<void> checkOutside(const NamedOutput& folder, Places& places, std::span<const NamedOutput> outputs,
                          std::span<const std::string> inputs) {
    const fs::path place = places.of(folder.path);
    for (const NamedOutput& each : outputs)
        if (&each != &folder && !each.path.empty() && isWithin(places.of(each.path), place))
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected a file outside of {0}, which {1} fills", inQuotes(folder.path),
                                 folder.option),
                        atOption(each.option));
    for (const std::string& each : inputs)
        if (!each.empty() && isWithin(places.of(each), place))
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected a folder other than that of {0}, which is read", inQuotes(each)),
                        atOption(folder.option));
    return {};
}

} // namespace

std::vector<NamedOutput> outputsOf(const char* option, std::span<const std::string> files) {
    std::vector<NamedOutput> outputs;
    for (const std::string& each : files)
        outputs.push_back({option, each});
    return outputs;
}

std::vector<std::string> filesIn(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const auto& each : fs::directory_iterator(folder, ignored))
        files.push_back(each.path().string());
    return files;
}

Result<void> checkNotRead(std::span<const NamedOutput> outputs, std::span<const std::string> inputs) {
    std::map<FileId, std::string> read;
    for (const std::string& each : inputs)
        if (const auto id = idOf(isStandardInput(each) ? "/dev/stdin" : each))
            read.emplace(*id, inputName(each));
    for (const NamedOutput& each : outputs) {
        const auto id = idOf(isStandardOutput(each.path) ? "/dev/stdout" : each.path);
        if (const auto input = id ? read.find(*id) : read.end(); input != read.end())
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected a file other than {0}, which is read", inQuotes(input->second)),
                        atOption(each.option));
    }
    return {};
}

Result<void> checkOutputsApart(std::span<const NamedOutput> outputs, std::span<const std::string> inputs) {
    if (Result<void> apart = checkNotRead(outputs, inputs); !apart)
        return apart;
    std::map<FileId, const NamedOutput*> files;
    std::map<fs::path, const NamedOutput*> places;
    const NamedOutput* printed = nullptr;
    Places placeOf;
    for (const NamedOutput& each : outputs) {
        if (isStandardOutput(each.path)) {
            if (printed != nullptr)
                return fail(ErrorCode::OutOfRange, "expected one text on standard output, found two",
                            atOption(fmt::format("{} and {}", printed->option, each.option)));
            printed = &each;
        }
        if (each.path.empty() || isStandardOutput(each.path) || isCharacterDevice(each.path))
            continue;
        if (const auto [same, isNew] = places.emplace(placeOf.of(each.path), &each); !isNew)
            return takesThePlaceOf(*same->second, each);
        if (const auto id = idOf(each.path))
            if (const auto [same, isNew] = files.emplace(*id, &each); !isNew)
                return takesThePlaceOf(*same->second, each);
    }
    for (const NamedOutput& each : outputs)
        if (each.isFolder && !each.path.empty())
            if (Result<void> outside = checkOutside(each, placeOf, outputs, inputs); !outside)
                return outside;
    return {};
}

} // namespace texplorer::screenshot
