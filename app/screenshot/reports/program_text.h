#pragma once

#include "app/screenshot/arguments/scene_argument.h"
#include "texplorer/emit/program.h"
#include "texplorer/lesson/lesson_scene.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// An image file that a program reads.
struct ReadFile {
    std::string name; ///< as the program calls it
    Bytes bytes;
};

struct ProgramText {
    std::vector<emit::Line> lines;
    std::vector<ReadFile> files{};       ///< which are to be written beside the program
    std::vector<std::string> madeFrom{}; ///< the scene's files, the place of which no program may take
};

/// Where a program looks for the image files that it reads.
enum class FilePlaces : bool {
    WhereTheyAre, ///< those of the program's lessons are nowhere: their texels stand in the program
    Beside,       ///< copies lie in the program's folder, of a lesson alone, under names that aren't its own
};

/// The program that draws the scene of a command line. With a lesson its text is said at the top, and what
/// the step is about has a word on it. options.source is the path of the program: images are named from
/// there.
[[nodiscard]] tl::expected<ProgramText, SceneProblem> programOf(const SceneArgument& argument,
                                                                emit::Flavour flavour,
                                                                emit::ProgramOptions options,
                                                                FilePlaces files = FilePlaces::WhereTheyAre);

/// The parameters that a step of a lesson is about.
[[nodiscard]] std::set<std::string, std::less<>> subjectsOf(const lesson::Step& step);

/// The same of a lesson's step whose scene is at hand, with the files beside it. `source` is the program's
/// name.
[[nodiscard]] Result<ProgramText> programOfStep(const lesson::Lesson& lesson, std::size_t step,
                                                const lesson::LessonScene& scene, emit::Flavour flavour,
                                                const std::string& source, emit::TextureCodes& codes);

} // namespace texplorer::screenshot
