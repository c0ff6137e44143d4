#include "app/screenshot/gl/gl_module.h"

#include <dlfcn.h>
#include <filesystem>

namespace texplorer::screenshot {

namespace {

/// An entry point of the module beside this program.
template<class Entry>
Result<Entry> findEntry(const char* name) {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path module = program.parent_path().parent_path() / "lib/texplorer/texshot_gl.so";

    // Never unloaded: Mesa leaves threads and exit handlers behind.
    void* handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!handle)
        return fail(ErrorCode::Driver, std::string("can't load the part that draws: ") + dlerror());
    const auto entry = reinterpret_cast<Entry>(dlsym(handle, name));
    if (!entry)
        return fail(ErrorCode::Driver, std::string("it has no entry point ") + name, module.string());
    return entry;
}

} // namespace

Result<Shot> draw(const ShotRequest& request) {
    const Result<DrawEntry> entry = findEntry<DrawEntry>(drawEntryName);
    if (!entry)
        return fail(entry.error());
    Result<Shot> shot;
    (*entry)(request, shot);
    return shot;
}

Result<std::unique_ptr<Studio>> openStudio(const std::filesystem::path& shaders,
                                           const view::Pretence& pretence) {
    const Result<StudioEntry> entry = findEntry<StudioEntry>(studioEntryName);
    if (!entry)
        return fail(entry.error());
    Result<std::unique_ptr<Studio>> studio;
    (*entry)(shaders, pretence, studio);
    return studio;
}

} // namespace texplorer::screenshot
