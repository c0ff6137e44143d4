#include "app/screenshot/scene_argument.h"
#include "core/base/file_io.h"
#include "core/scene/diagnosis.h"
#include "core/scene/initial_like.h"
#include "core/scene/params.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace texplorer::screenshot {
namespace {

struct Options {
    SceneArgument scene;
    bool json = false;
};

/// Reads the images one by one: all that can't be read are reported, each with its reason.
void loadImages(OpenedScene& opened, std::vector<std::string>& reasons) {
    reasons.resize(opened.scene.textures.size());
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        Scene alone;
        alone.textures = {opened.scene.textures[i]};
        if (alone.textures[0].source != SourceKind::File || alone.textures[0].file.empty())
            continue;
        if (const Result<void> loaded = opened.images.load(alone); !loaded)
            reasons[i] = describe(loaded.error());
    }
}

/// What is at its initial value has been set by nobody: that it has no effect is no news.
bool isWorthSaying(const Finding& finding, const Scene& scene, const Scene& initial) {
    if (finding.severity <= Severity::Warning)
        return true;
    const Result<std::string> value = getParam(scene, finding.path);
    const Result<std::string> start = getParam(initial, finding.path);
    return value && start && *value != *start;
}

std::string asText(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& each : findings) {
        text += std::string(rowOf(each.severity).name) + ": " + each.path + ": " +
                (each.severity >= Severity::Hint ? "no effect: " : "") + each.sentence + "\n";
        if (!each.fix)
            continue;
        text += "    " + each.fix->label + ":";
        for (const Assignment& set : each.fix->assignments)
            text += " --set " + set.path + "=" + set.value;
        text += "\n";
    }
    return text;
}

std::string asJson(const std::vector<Finding>& findings) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& each : findings) {
        nlohmann::ordered_json entry{{"severity", rowOf(each.severity).name},
                                     {"rule", each.rule},
                                     {"path", each.path},
                                     {"sentence", each.sentence}};
        if (each.fix) {
            nlohmann::ordered_json set = nlohmann::ordered_json::object();
            for (const Assignment& one : each.fix->assignments)
                set[one.path] = one.value;
            entry["fix"] = {{"label", each.fix->label}, {"set", std::move(set)}};
        }
        list.push_back(std::move(entry));
    }
    // A file's name may be no UTF-8.
    return nlohmann::ordered_json{{"findings", std::move(list)}}.dump(
               2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
           "\n";
}

ExitCode check(const Options& options) {
    auto opened = openScene(options.scene);
    if (!opened)
        return opened.error();
    std::vector<std::string> reasons;
    loadImages(*opened, reasons);
    std::vector<Finding> findings = diagnose(opened->scene, opened->images);
    const Scene initial = initialLike(opened->scene);
    std::erase_if(findings,
                  [&](const Finding& each) { return !isWorthSaying(each, opened->scene, initial); });
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        for (Finding& each : findings) {
            if (!reasons[i].empty() && each.path == "textures[" + std::to_string(i) + "].file")
                each.sentence = reasons[i];
        }
    }
    const std::string text = options.json ? asJson(findings) : asText(findings);
    if (const auto written = writeOutput("-", viewBytes(text)); !written)
        return complain(written.error());
    const bool clean = std::ranges::none_of(
        findings, [](const Finding& each) { return each.severity <= Severity::Warning; });
    return clean ? success : failure;
}

} // namespace

void addCheck(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("check", "What is wrong in a scene, undefined, or without effect.");
    auto options = std::make_shared<Options>();
    addSceneArgument(*command, options->scene);
    command->add_flag("--json", options->json, "As JSON, for programs.");
    command->footer("A line for each finding on standard output, errors first, and below it what mends it. "
                    "Settings without\n"
                    "effect are named where they differ from their initial value. The driver is not asked: "
                    "\"texshot shot\"\n"
                    "says what it lacks.\n"
                    "Exit status: 0 there is no error and no warning, 1 there is one or the scene can't be "
                    "read, 2 a wrong call.");
    command->callback([&action, options] { action = [options] { return check(*options); }; });
}

} // namespace texplorer::screenshot
