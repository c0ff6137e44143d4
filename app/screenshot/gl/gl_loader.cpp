#include "app/screenshot/gl/gl_module.h"

#include <fmt/core.h>

#include <array>
#include <dlfcn.h>
#include <filesystem>
#include <string>

namespace texplorer::screenshot {

namespace {

/// What draws in which kind of context. The first that can be loaded is Auto's.
struct ModuleRow {
    const char* file;
    const char* name;
    bool isEgl;
};

constexpr std::array moduleRows{
#ifdef TEXPLORER_OSMESA
    ModuleRow{"texshot_osmesa.so", "OSMesa", false},
#endif
#ifdef TEXPLORER_EGL
    ModuleRow{"texshot_egl.so", "EGL", true},
#endif
};

using ContextKind = view::ContextChoice::Kind;

bool serves(const ModuleRow& row, const view::ContextChoice& choice) {
    return choice.kind == ContextKind::Auto || (choice.kind != ContextKind::Osmesa) == row.isEgl;
}

/// The module beside this program. Never unloaded: Mesa leaves threads and exit handlers behind. What it
/// brings is its own: OSMesa and EGL define functions of the same names.
Result<void*> loadModule(const ModuleRow& row) {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path module = program.parent_path().parent_path() / "lib/texplorer" / row.file;
    if (void* handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL))
        return handle;
    return fail(ErrorCode::Driver,
                fmt::format("can't load the part that draws by {}: {}", row.name, dlerror()));
}

/// An entry point of the module that serves the choice.
template<class Entry>
Result<Entry> findEntry(const view::ContextChoice& choice, const char* name) {
    std::string reasons;
    for (const ModuleRow& row : moduleRows) {
        if (!serves(row, choice))
            continue;
        const Result<void*> module = loadModule(row);
        if (!module) {
            reasons.append(reasons.empty() ? "" : "; ").append(module.error().message);
            continue;
        }
        if (const auto entry = reinterpret_cast<Entry>(dlsym(*module, name)))
            return entry;
        return fail(ErrorCode::Driver, fmt::format("it has no entry point {}", name), row.file);
    }
    if (!reasons.empty())
        return fail(ErrorCode::Driver, reasons);
    return fail(ErrorCode::Unsupported,
                fmt::format("this texshot was built without {}",
                            choice.kind == ContextKind::Osmesa ? "OSMesa" : "EGL"),
                "--context");
}

} // namespace

Result<Shot> draw(const ShotRequest& request) {
    const Result<DrawEntry> entry = findEntry<DrawEntry>(request.context, drawEntryName);
    if (!entry)
        return fail(entry.error());
    Result<Shot> shot;
    (*entry)(request, shot);
    return shot;
}

Result<std::unique_ptr<Studio>> openStudio(const std::filesystem::path& shaders,
                                           const view::Pretence& pretence,
                                           const view::ContextChoice& context) {
    const Result<StudioEntry> entry = findEntry<StudioEntry>(context, studioEntryName);
    if (!entry)
        return fail(entry.error());
    Result<std::unique_ptr<Studio>> studio;
    (*entry)(shaders, pretence, context, studio);
    return studio;
}

} // namespace texplorer::screenshot
