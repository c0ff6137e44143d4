#include "app/screenshot/gl/driver_crash.h"
#include "app/screenshot/gl/driver_question.h"
#include "app/screenshot/gl/gl_module.h"

#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <string>

namespace texplorer::screenshot {

namespace {

using ContextKind = view::ContextChoice::Kind;

/// What draws in which kind of context. The first that can be loaded is Auto's.
struct ModuleRow {
    const char* file;
    const char* name;
    ContextKind kind;
};

constexpr std::array moduleRows{
#ifdef TEXPLORER_OSMESA
    ModuleRow{"texshot_osmesa.so", "OSMesa", ContextKind::Osmesa},
#endif
#ifdef TEXPLORER_EGL
    ModuleRow{"texshot_egl.so", "EGL", ContextKind::Egl},
#endif
};

bool serves(const ModuleRow& row, const view::ContextChoice& choice) {
    return choice.kind == ContextKind::Auto ||
           (choice.kind == ContextKind::Osmesa) == (row.kind == ContextKind::Osmesa);
}

/// The module beside this program. Never unloaded: Mesa leaves threads and exit handlers behind. What it
/// brings is its own: OSMesa and EGL define functions of the same names.
Result<void*> loadModule(const ModuleRow& row) {
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::filesystem::path module = program.parent_path().parent_path() / "lib/texplorer" / row.file;
    driverIsLoaded();
    if (void* handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL))
        return handle;
    return fail(ErrorCode::Driver, Sentence("can't load the module for {0}: {1}", row.name, dlerror()));
}

template<class Entry>
struct FoundEntry {
    Entry call;
    ContextKind kind; ///< Osmesa or Egl: whose it is
};

/// An entry point of the module that serves the choice.
template<class Entry>
Result<FoundEntry<Entry>> findEntry(const view::ContextChoice& choice, const char* name) {
    std::vector<Sentence> reasons;
    for (const ModuleRow& row : moduleRows) {
        if (!serves(row, choice))
            continue;
        const Result<void*> module = loadModule(row);
        if (!module) {
            reasons.push_back(module.error().message);
            continue;
        }
        if (const auto entry = reinterpret_cast<Entry>(dlsym(*module, name)))
            return FoundEntry<Entry>{entry, row.kind};
        return fail(ErrorCode::Driver, Sentence("it has no entry point {0}", name), inFile(row.file));
    }
    if (!reasons.empty())
        return fail(ErrorCode::Driver, Sentence::joined("{0}; {1}", reasons));
    return fail(
        ErrorCode::Unsupported,
        Sentence("this texshot was built without {0}", choice.kind == ContextKind::Osmesa ? "OSMesa" : "EGL"),
        atOption("--context"));
}

/// With which one names a driver other than the usual one.
constexpr std::array driverVariables{"GALLIUM_DRIVER", "LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_FILENAMES",
                                     "MESA_LOADER_DRIVER_OVERRIDE", "__EGL_VENDOR_LIBRARY_DIRS"};

/// "GALLIUM_DRIVER is \"zink\""; empty: nobody named one.
std::string namedDriver() {
    std::string text;
    for (const char* variable : driverVariables) {
        const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nobody changes it
        if (value && *value != '\0')
            text += fmt::format("{}{} is \"{}\"", text.empty() ? "" : ", ", variable, value);
    }
    return text;
}

/// An entry point to draw with. A driver that somebody named, and that may be none or not get along with this
/// machine, is asked in another process first. OSMesa's are known by name.
template<class Entry>
Result<Entry> findTriedEntry(const view::ContextChoice& choice, const char* name) {
    const Result<FoundEntry<Entry>> entry = findEntry<Entry>(choice, name);
    if (!entry)
        return fail(entry.error());
    if (const std::string named = namedDriver(); entry->kind == ContextKind::Egl && !named.empty()) {
        if (const Result<DriverReport> answer = askDriver(choice); !answer)
            return fail(answer.error().code, Sentence("{0} ({1})", answer.error().message, named));
    }
    return entry->call;
}

} // namespace

Result<Shot> draw(const ShotRequest& request) {
    const Result<DrawEntry> entry = findTriedEntry<DrawEntry>(request.context, drawEntryName);
    if (!entry)
        return fail(entry.error());
    Result<Shot> shot;
    (*entry)(request, shot);
    return shot;
}

Result<std::unique_ptr<Studio>> openStudio(const std::filesystem::path& shaders,
                                           const view::Pretence& pretence,
                                           const view::ContextChoice& context) {
    const Result<StudioEntry> entry = findTriedEntry<StudioEntry>(context, studioEntryName);
    if (!entry)
        return fail(entry.error());
    Result<std::unique_ptr<Studio>> studio;
    (*entry)(shaders, pretence, context, studio);
    return studio;
}

Result<std::vector<view::ContextChoice>> contextsOf(const view::ContextChoice& choice) {
    const Result<FoundEntry<ContextsEntry>> entry = findEntry<ContextsEntry>(choice, contextsEntryName);
    if (!entry)
        return fail(entry.error());
    std::vector<view::ContextChoice> contexts;
    entry->call(contexts);
    return contexts;
}

Result<DriverReport> reportDriver(const view::ContextChoice& choice) {
    const Result<FoundEntry<DriverEntry>> entry = findEntry<DriverEntry>(choice, driverEntryName);
    if (!entry)
        return fail(entry.error());
    Result<DriverReport> report;
    entry->call(choice, report);
    return report;
}

std::vector<view::ContextChoice> builtContexts() {
    std::vector<view::ContextChoice> built;
    built.reserve(moduleRows.size());
    for (const ModuleRow& row : moduleRows)
        built.push_back({row.kind, 0});
    return built;
}

} // namespace texplorer::screenshot
