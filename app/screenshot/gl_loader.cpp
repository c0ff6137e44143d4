#include "app/screenshot/gl_module.h"

#include <dlfcn.h>
#include <filesystem>

namespace texplorer::screenshot {

Result<Picture> draw(const Drawing& drawing) {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path module = program.parent_path().parent_path() / "lib/texplorer/texshot_gl.so";

    // Never unloaded: Mesa leaves threads and exit handlers behind.
    void* handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!handle)
        return fail(ErrorCode::Driver, std::string("can't load the part that draws: ") + dlerror());
    const auto entry = reinterpret_cast<DrawEntry>(dlsym(handle, drawEntryName));
    if (!entry)
        return fail(ErrorCode::Driver, std::string("it has no entry point ") + drawEntryName,
                    module.string());

    Result<Picture> picture;
    entry(drawing, picture);
    return picture;
}

} // namespace texplorer::screenshot
