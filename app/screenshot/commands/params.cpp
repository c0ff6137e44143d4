#include "app/screenshot/command.h"
#include "core/scene/params/param_listing.h"

namespace texplorer::screenshot {

void addParams(CommandLine& line) {
    Command& command =
        line.command("params", "Every parameter of a scene: what it has unless a file says otherwise, "
                               "what it accepts and does.");
    auto json = std::make_shared<bool>(false);
    command.flag("--json", *json, "As JSON, for programs.");
    command.onCall([json] {
        const std::string text = *json ? listParamsJson() : listParams();
        if (const auto written = print(text); !written)
            return complain(written.error());
        return success;
    });
}

} // namespace texplorer::screenshot
