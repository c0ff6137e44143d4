#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/driver_question.h"
#include "app/screenshot/output/json_text.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <span>

namespace texplorer::screenshot {
namespace {

struct DriversOptions {
    bool json = false;
    bool extensions = false;
    int seconds = defaultDriverSeconds;
};

bool canDraw(const DriverAnswer& answer) {
    return answer.report && answer.report->lack.empty();
}

std::string line(std::string_view name, std::string_view value) {
    return fmt::format("  {:16}{}\n", name, printable(value));
}

std::string driversText(const DriverReport& report, bool extensions) {
    std::string text = line("renderer", report.renderer) + line("vendor", report.vendor) +
                       line("version", report.version) +
                       line("GLSL", report.shadingLanguage.empty() ? "none" : report.shadingLanguage) +
                       line("profile", report.isCore ? "core" : "compatibility") +
                       line("largest texture", fmt::format("{0} × {0}", report.maxTextureSize));
    if (report.lack.empty()) // else nobody has asked
        text += line("anisotropy", report.maxAnisotropy > 1
                                       ? fmt::format("up to {}", formatNumber(report.maxAnisotropy))
                                       : "none") +
                line("S3TC", report.s3tc ? "yes" : "no") +
                line("texture borders", report.textureBorders ? "yes" : "no: the driver drops them");
    text += line("extensions", fmt::format("{}", report.extensions.size()));
    for (const std::string& name : extensions ? report.extensions : std::vector<std::string>())
        text += fmt::format("    {}\n", printable(name));
    if (!report.lack.empty())
        text += line("not usable", report.lack);
    return text;
}

std::string driversText(std::span<const DriverAnswer> answers, bool extensions) {
    std::string text;
    for (const DriverAnswer& each : answers) {
        text += fmt::format("{}{}\n", text.empty() ? "" : "\n", each.context.text());
        text += each.report ? driversText(*each.report, extensions)
                            : line("not usable", describe(each.report.error()));
    }
    return text;
}

std::string driversJson(std::span<const DriverAnswer> answers, bool extensions) {
    nlohmann::ordered_json contexts = nlohmann::ordered_json::array();
    for (const DriverAnswer& each : answers) {
        nlohmann::ordered_json context{{"context", each.context.text()}, {"usable", canDraw(each)}};
        if (!each.report) {
            context["error"] = problemJson(each.report.error());
        } else {
            const DriverReport& report = *each.report;
            if (!report.lack.empty())
                context["error"] = problemJson({ErrorCode::Unsupported, report.lack, {}});
            context["driver"] = report.renderer;
            context["vendor"] = report.vendor;
            context["version"] = report.version;
            context["shadingLanguage"] = report.shadingLanguage;
            context["profile"] = report.isCore ? "core" : "compatibility";
            context["maxTextureSize"] = report.maxTextureSize;
            if (report.lack.empty()) {
                context["maxAnisotropy"] = report.maxAnisotropy;
                context["s3tc"] = report.s3tc;
                context["textureBorders"] = report.textureBorders;
            }
            context["extensionCount"] = report.extensions.size();
            if (extensions)
                context["extensions"] = report.extensions;
        }
        contexts.push_back(std::move(context));
    }
    return documentText(std::move(contexts));
}

ExitCode listDrivers(const DriversOptions& options) {
    const Result<std::vector<DriverAnswer>> answers = askDrivers(options.seconds);
    if (!answers)
        return complain(answers.error());
    const ExitCode status =
        std::ranges::any_of(*answers, canDraw)
            ? success
            : complain({ErrorCode::Driver, N_("Texplorer can't draw in any of these contexts"), {}});
    const std::string text =
        options.json ? driversJson(*answers, options.extensions) : driversText(*answers, options.extensions);
    if (const Result<void> printed = print(text); !printed)
        return complain(printed.error());
    return status;
}

} // namespace

void addDrivers(CommandLine& line) {
    Command& command =
        line.command("drivers", "List the OpenGL contexts of --context and the features of each driver.");
    auto options = std::make_shared<DriversOptions>();
    command.flag("--extensions", options->extensions, "List each driver's extensions.");
    command.flag("--json", options->json, "As JSON, for programs.");
    command.number("--timeout,--time-limit", options->seconds, 1, 3600,
                   "The maximum time for a driver to answer, in seconds.", {.showsDefault = true});
    command.footer(
        "Each driver runs in a separate process, so crashes and hangs are reported in the list. Exit "
        "status: 0 Texplorer can draw in one of the contexts, 1 in none.\n"
        "Mesa reads these variables, in this and all other commands that draw:\n"
        "GALLIUM_DRIVER=llvmpipe or softpipe: the driver that draws on the CPU. With EGL also zink or "
        "d3d12, which draw with Vulkan and Direct3D.\n"
        "LP_NUM_THREADS=N: the number of threads of llvmpipe, 0 to 32. Pictures do not change.\n"
        "GALLIVM_PERF=no_rho_approx,no_brilinear,no_quad_lod,no_aos_sampling: llvmpipe selects and filters "
        "mip levels without approximations, as in \"texshot conform\".\n"
        "MESA_GL_VERSION_OVERRIDE=2.1 and MESA_EXTENSION_OVERRIDE=-GL_EXT_texture_compression_s3tc: like "
        "an older driver. --pretend disables more, for any driver.\n"
        "LIBGL_ALWAYS_SOFTWARE=1, with EGL: on the CPU even if there is a GPU. "
        "MESA_LOADER_DRIVER_OVERRIDE=zink: another driver for the GPU. LIBGL_DRIVERS_PATH=DIR: the folder "
        "of Mesa's drivers.\n"
        "__EGL_VENDOR_LIBRARY_FILENAMES=FILE.json: the EGL to use, if several are installed.\n"
        "MESA_SHADER_CACHE_DIR=DIR: where Mesa keeps compiled shaders; MESA_SHADER_CACHE_DISABLE=true: "
        "nowhere.\n"
        "OSMesa has only llvmpipe and softpipe.");
    command.onCall([options] { return listDrivers(*options); });
}

} // namespace texplorer::screenshot
