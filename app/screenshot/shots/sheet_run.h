#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/answer.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/sheet_report.h"
#include "app/screenshot/shots/shot_list.h"
#include "texplorer/sheet/layout.h"
#include "texplorer/sheet/lettering.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Sheets of pictures, and what they have in common.
struct SheetRun {
    struct Page {
        ImageOutput output;
        sheet::Layout layout;
        Scene scene;                   ///< that its pictures are variations of
        std::vector<std::string> axes; ///< as --axis takes them
    };

    const ShotList& list; ///< of one scene; the pictures of a page follow each other
    std::vector<Page> pages;
    ShotRequest common; ///< all but scene, images, file, time and size
    const sheet::Lettering& lettering;
    bool difference = false; ///< from the first picture of all, in the place of the others
    bool withTexts = true;   ///< see textsOf
    std::vector<WrittenSheet>* written = nullptr; ///< gets what was written; none: nobody asks
};

/// Below a picture that shows its difference: "12 pixels differ".
[[nodiscard]] std::string wordsOfDifference(std::size_t pixels);

/// Draws all of them. Where a picture can't be drawn its place says so, and the exit status is a failure's; a
/// sheet without any picture isn't written.
[[nodiscard]] ExitCode drawSheets(const SheetRun& run);

} // namespace texplorer::screenshot
