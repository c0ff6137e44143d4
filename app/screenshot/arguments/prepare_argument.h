#pragma once

#include "app/command_line/command_line.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// The steps that prepare a picture, as those of a texture do.
struct PrepareArgument {
    std::string swizzle;
    std::string size;
    std::string scale;
    bool spread = false;
    bool premultiply = false;
    std::string normals;
};

/// Declares --swizzle, --size, --scale, --spread, --premultiply and --normals.
void addPrepareArgument(Command& command, PrepareArgument& argument);

/// Those that are asked for, in the order in which they are made: that of their declaration.
[[nodiscard]] Result<std::vector<ImageStep>> stepsOf(const PrepareArgument& argument);

/// A level of a picture, bottom row first, after the steps.
[[nodiscard]] Image preparedBy(const std::vector<ImageStep>& steps, Image picture, int level = 0);

} // namespace texplorer::screenshot
