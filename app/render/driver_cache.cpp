#include "app/render/driver_cache.h"

#include "texplorer/files/descriptor.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/files/user_folder.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer::render {

namespace {

namespace fs = std::filesystem;

/// The subfolder that Mesa creates in the directory (Mesa 22.3, src/util/disk_cache_os.c).
constexpr const char* cacheName = "mesa_shader_cache";
constexpr const char* indexName = "index";
/// A counter, then 65,536 keys of 20 bytes. An index of this size is left unchanged.
constexpr off_t indexBytes = 8 + 65536 * 20;

constexpr const char* directoryVariable = "MESA_SHADER_CACHE_DIR";
constexpr const char* disableVariable = "MESA_SHADER_CACHE_DISABLE";
// Before Mesa 22.3.
constexpr const char* oldDirectoryVariable = "MESA_GLSL_CACHE_DIR";
constexpr const char* oldDisableVariable = "MESA_GLSL_CACHE_DISABLE";
constexpr const char* sizeVariable = "MESA_SHADER_CACHE_MAX_SIZE";
constexpr const char* maxCacheSize = "256M"; // Mesa's default is 1 GB

using SignalHandler = void (*)(int);

tl::unexpected<Error> refuse(const Sentence& message, const fs::path& path) {
    return fail(ErrorCode::Unwritable, message, inFile(path.string()));
}

const char* valueOf(const char* variable) {
    const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): before any other thread
    return value && *value != '\0' ? value : nullptr;
}

void set(const char* variable, const std::string& value) {
    static_cast<void>(::setenv(variable, value.c_str(), 1)); // NOLINT(concurrency-mt-unsafe): as above
}

bool isSwitchedOff() {
    for (const char* variable : {disableVariable, oldDisableVariable}) {
        const char* value = valueOf(variable);
        if (value && (std::string_view(value) == "true" || std::string_view(value) == "1"))
            return true;
    }
    return false;
}

/// The user's choice, or a folder in Texplorer's directory; empty: none.
fs::path wantedDirectory() {
    for (const char* variable : {directoryVariable, oldDirectoryVariable}) {
        if (const char* value = valueOf(variable))
            return value;
    }
    const fs::path caches = userFolder("XDG_CACHE_HOME", ".cache");
    return caches.empty() ? fs::path() : caches / "texplorer" / "driver";
}

Result<void> makePrivate(const fs::path& directory) {
    if (::mkdir(directory.c_str(), S_IRWXU) != 0 && errno != EEXIST)
        return refuse(Sentence("can't be made: {0}", systemText(errno)), directory);
    const Descriptor opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat found {};
    if (!opened.valid() || ::fstat(opened.get(), &found) != 0)
        return refuse(Sentence("is not a private directory: {0}", systemText(errno)), directory);
    if (found.st_uid != ::geteuid())
        return refuse("belongs to another user", directory);
    if ((found.st_mode & (S_IWGRP | S_IWOTH)) != 0)
        return refuse("is writable by others", directory);
    return {};
}

} // namespace

Result<void> checkDriverCache(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory.parent_path(), error); // if this fails, the next call fails as well
    const fs::path cache = directory / cacheName;
    for (const fs::path& each : {directory, cache}) {
        if (Result<void> made = makePrivate(each); !made)
            return made;
    }
    const fs::path index = cache / indexName;
    const Descriptor opened(
        ::open(index.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600));
    struct stat found {};
    if (!opened.valid() || ::fstat(opened.get(), &found) != 0)
        return refuse(Sentence("can't be opened: {0}", systemText(errno)), index);
    if (!S_ISREG(found.st_mode) || found.st_uid != ::geteuid())
        return refuse("is not a private file", index);
    // Also if the file has the right length: a file with holes has no blocks on the disk.
    const SignalHandler before =
        std::signal(SIGXFSZ, SIG_IGN); // a limit must return an error, not end the process
    const int failed = ::posix_fallocate(opened.get(), 0, indexBytes);
    std::signal(SIGXFSZ, before);
    if (failed != 0)
        return refuse(Sentence("it needs {0} bytes: {1}", indexBytes, systemText(failed)), index);
    return {};
}

void setUpDriverCache() {
    if (isSwitchedOff())
        return;
    const fs::path directory = wantedDirectory();
    if (directory.empty() || !checkDriverCache(directory)) {
        set(disableVariable, "true");
        return;
    }
    set(directoryVariable, directory.string());
    if (!valueOf(sizeVariable))
        set(sizeVariable, maxCacheSize);
}

} // namespace texplorer::render
