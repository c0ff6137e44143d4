#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "texplorer/scene/params/scene_diff.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>

namespace texplorer::screenshot {
namespace {

struct DiffOptions {
    std::string from;
    std::string to;
    bool json = false;
};

// As of diff(1): what can't be told has a status of its own.
constexpr int scenesAreSame = 0;
constexpr int scenesDiffer = 1;
constexpr ExitCode scenesUnknown = wrongCall;

std::string changesText(const std::vector<SceneChange>& changes) {
    std::string text;
    for (const SceneChange& each : changes)
        text += fmt::format("{}: {} -> {}\n", each.path, printable(each.from), printable(each.to));
    return text;
}

std::string changesJson(const std::vector<SceneChange>& changes) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SceneChange& each : changes)
        list.push_back({{"path", each.path},
                        {"label", each.label},
                        {"from", each.from.english()},
                        {"to", each.to.english()}});
    return documentText(std::move(list));
}

int diff(const DiffOptions& options) {
    if (const Result<void> once = checkStandardInputOnce(std::array{options.from, options.to}); !once)
        return complain(once.error(), wrongCall);
    std::array<Scene, 2> scenes;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto opened = openScene({.file = i == 0 ? options.from : options.to});
        if (!opened)
            return complain(opened.error().error, scenesUnknown);
        scenes[i] = opened->scene;
    }
    const std::vector<SceneChange> changes = changesBetween(scenes[0], scenes[1]);
    const Result<void> written = print(options.json ? changesJson(changes) : changesText(changes));
    if (!written)
        return complain(written.error(), scenesUnknown);
    return changes.empty() ? scenesAreSame : scenesDiffer;
}

} // namespace

void addDiff(CommandLine& line) {
    Command& command = line.command("diff", "List the differences between two scenes.");
    auto options = std::make_shared<DiffOptions>();
    command.option("FROM", options->from, "A scene file (JSON); - for standard input.", {.required = true});
    command.option("TO", options->to, "The other scene file.", {.required = true});
    command.flag("--json", options->json,
                 "As JSON, for programs: path, label, from and to of each difference.");
    command.footer(
        "A line for each parameter with different values. For lists of different lengths: the lengths, and "
        "the differences of their common elements.\n"
        "Exit status: 0 they are the same, 1 they differ, 2 one of them can't be read, or invalid "
        "arguments.");
    command.onCall([options] { return diff(*options); });
}

} // namespace texplorer::screenshot
