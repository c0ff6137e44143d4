#pragma once

#include "app/view/size.h"
#include "texplorer/codec/common/write_options.h"
#include "texplorer/conform/pair.h"
#include "texplorer/scene/params/sweep_axis.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::view {

/// What a picture's file says of how it was drawn.
struct PictureFacts {
    Scene scene;
    double time = 0;      ///< seconds
    Size size;            ///< of a sheet that of each picture
    std::string renderer; ///< "fixed"; of a window that compares, several with commas
    conform::Driver driver{};
    std::string context{};
    std::vector<std::string> axes{}; ///< of a sheet, as --axis takes them
    std::string program{"texshot"};  ///< which has drawn it
};

/// As texts for its file: the program with its version, the renderer, the driver and its context where
/// OpenGL drew it, time, size, the axes of a sheet, and the complete scene as JSON. No clock, no names of
/// machines or folders: the same call gives the same texts.
[[nodiscard]] std::vector<PictureText> textsOf(const PictureFacts& facts);

/// An axis as --axis takes it, with these of its values: "textures[0].wrapS=GL_REPEAT,GL_CLAMP".
[[nodiscard]] std::string axisText(const SweepAxis& axis, std::span<const std::string> values);

} // namespace texplorer::view
