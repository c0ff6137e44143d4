#pragma once

#include "app/command_line/command_line.h"
#include "app/screenshot/gl/gl_module.h"

#include <string>

namespace texplorer::screenshot {

/// What the whole window shows, as the command line spells it.
struct WindowArgument {
    std::string tab;
    std::string figure;
    std::string layout;
    std::string theme;
    std::string language;
    std::string scale;
    bool largeControls = false;
    int tour = 0;
    std::string section;
    std::string probe;
    std::string compared;
};

/// Declares --tab, --figure, --layout, --theme, --language, --scale, --large-controls, --tour, --section,
/// --probe and --compare, which need the option `window`.
void addWindowArgument(Command& command, const Option& window, WindowArgument& argument);

/// Into the request; the error is a wrong call.
[[nodiscard]] Result<void> putWindow(const WindowArgument& argument, ShotRequest& request);

} // namespace texplorer::screenshot
