#include "app/screenshot/arguments/axes_argument.h"

#include "app/screenshot/arguments/scene_argument.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::screenshot {

void addAxesArgument(Command& command, std::vector<std::string>& axes, const std::string& what,
                     bool required) {
    command.option(
        "--axis", axes,
        fmt::format(
            "A parameter and its values, as in 'textures[0].minFilter=*': {}. V1,V2 are values (of vectors "
            "and colours with ; between them), A..B/N are N numbers, * is every choice.",
            what),
        {.value = "PATH=VALUES",
         .required = required,
         .oneEach = true,
         .offers = {.assigned = assignedParams}});
}

Result<std::vector<SweepAxis>> parseAxes(const Scene& scene, const std::vector<std::string>& axes) {
    std::vector<SweepAxis> parsed;
    for (const std::string& text : axes) {
        Result<SweepAxis> axis = parseSweepAxis(scene, text);
        if (!axis)
            return fail(axis.error());
        if (std::ranges::find(parsed, axis->path, &SweepAxis::path) != parsed.end())
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected each axis once, found {0} twice", axis->path), atOption("--axis"));
        parsed.push_back(*std::move(axis));
    }
    return parsed;
}

} // namespace texplorer::screenshot
