#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "core/codec/common/write_options.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// What a picture's file says of how it was drawn.
struct PictureFacts {
    Scene scene;
    double time = 0;      ///< seconds
    view::Size size;      ///< of a sheet that of each picture
    std::string renderer; ///< "fixed"; of a window that compares, several with commas
    conform::Driver driver{};
    std::string context{};
    std::vector<std::string> axes{}; ///< of a sheet, as --axis takes them
};

[[nodiscard]] PictureFacts factsOf(const ShotRequest& request, const Shot& shot);

/// As texts for its file: the program, the renderer, the driver and its context where OpenGL drew it, time,
/// size, the axes of a sheet, and the complete scene as JSON. No clock, no names of machines or folders: the
/// same call gives the same texts.
[[nodiscard]] std::vector<PictureText> textsOf(const PictureFacts& facts);

} // namespace texplorer::screenshot
