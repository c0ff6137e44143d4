#include "app/screenshot/command.h"
#include "core/base/file_io.h"
#include "core/scene/param_listing.h"

namespace texplorer::screenshot {

void addParams(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("params", "Every parameter of a scene, its values and what they do.");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "As JSON, for programs.");
    command->callback([&action, json] {
        action = [json] {
            const std::string text = *json ? listParamsJson() : listParams();
            if (const auto written = writeOutput("-", viewBytes(text)); !written)
                return complain(written.error());
            return success;
        };
    });
}

} // namespace texplorer::screenshot
