#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/answer.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/shot_list.h"
#include "app/screenshot/shots/shot_report.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Draws the request's picture into an output. `scene` names it in errors about its images. `report`: see
/// ShotRun.
[[nodiscard]] ExitCode drawOne(ShotRequest request, const SceneArgument& scene, const ImageOutput& output,
                               bool withTexts, ShotReport* report = nullptr);

/// Many pictures, and what they have in common.
struct ShotRun {
    const ShotList& list;
    std::vector<std::string> names; ///< the files to write, one for each picture of the list
    const CodecRow* format;
    ShotRequest common;           ///< all but scene, images, file, renderer, time and size
    bool withTexts = true;        ///< see textsOf
    ShotReport* report = nullptr; ///< is told of every picture; none: nobody asks
    bool incomplete = false; ///< there are scenes that couldn't be read: it has failed from the beginning
};

/// Draws all of them, and goes on where one can't be drawn; a file that can't be written ends it.
[[nodiscard]] ExitCode drawAll(const ShotRun& run);

} // namespace texplorer::screenshot
