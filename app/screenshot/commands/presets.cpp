#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "texplorer/preset/preset.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace texplorer::screenshot {
namespace {

std::string presetsText() {
    std::string text;
    std::string_view group;
    for (const Preset& preset : presets()) {
        if (preset.group != group)
            text += fmt::format("{}{}\n", group.empty() ? "" : "\n", preset.group);
        group = preset.group;
        text +=
            fmt::format("  {}: {}\n    {}\n    {}\n", preset.name, preset.label, preset.help, preset.look);
    }
    return text;
}

std::string presetsJson() {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Preset& preset : presets())
        list.push_back({{"name", preset.name},
                        {"group", preset.group},
                        {"label", preset.label},
                        {"help", preset.help},
                        {"look", preset.look}});
    return documentText(std::move(list));
}

} // namespace

void addPresets(CommandLine& line) {
    Command& command =
        line.command("presets", "List the presets of \"shot --preset\": what each sets, and the result.");
    auto json = std::make_shared<bool>(false);
    command.flag("--json", *json, "As JSON, for programs: name, group, label, help and look of each preset.");
    command.onCall([json] {
        const Result<void> written = print(*json ? presetsJson() : presetsText());
        return written ? success : complain(written.error());
    });
}

} // namespace texplorer::screenshot
