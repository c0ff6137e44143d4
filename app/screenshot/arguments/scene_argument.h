#pragma once

#include "app/command_line/command_line.h"
#include "app/screenshot/output/answer.h"
#include "texplorer/lesson/lesson_files.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// The scene that a command line names, with its changes.
struct SceneArgument {
    std::string file; ///< empty: the default scene; "-": standard input
    std::vector<std::string> assignments{};
    std::vector<std::string> presets{}; ///< applied after them, to unit 0 of pass 0
    std::string example{};              ///< in the place of a file: "cube"; empty: none
    std::string lesson{};               ///< whose step's scene it is, in the place of a file; empty: none
    std::size_t step = 1;               ///< from 1
    std::size_t answer = 0;             ///< from 1, of the step's question; 0: what the step begins with
    bool reached = false;               ///< the scene of the picture that the step wants
    int units = maxUnits;               ///< how many texture units a step's scene may use
    TextureLimits limits{};             ///< of the driver that a program is written for

    /// Where it lies; empty: nowhere, as the default scene, or one that came from standard input. The images
    /// that it names are looked for in the current folder then.
    [[nodiscard]] std::filesystem::path path() const;
};

/// A lesson by its own name, or by a folder's.
[[nodiscard]] Result<lesson::LessonFolder> lessonFolder(const std::string& name);

/// Every parameter that --set takes, but lists of what each vertex has, for shells to offer.
[[nodiscard]] std::vector<Assigned> assignedParams();

/// The names of the program's examples, which --example takes: "cube".
[[nodiscard]] std::vector<std::string> exampleNames();

/// Declares SCENE, --example, --set and --preset; SCENE is what it returns.
const Option& addSceneArgument(Command& command, SceneArgument& argument,
                               std::vector<std::string>* files = nullptr);

/// The same with --lesson and its step, in the place of SCENE. With `files` there may be several scenes,
/// which go there; the argument's own file stays empty.
void addSceneOrLessonArgument(Command& command, SceneArgument& argument,
                              std::vector<std::string>* files = nullptr);

struct OpenedScene {
    Scene scene;
    ImageSource images;                             ///< nothing is loaded yet
    std::vector<std::filesystem::path> libraries{}; ///< of an OBJ file's materials
};

/// Why a scene can't be opened, and the exit status that this leads to.
struct SceneProblem {
    Error error;
    ExitCode code;
};

[[nodiscard]] tl::expected<OpenedScene, SceneProblem> openScene(const SceneArgument& argument);

/// What no output may take the place of: the scene's own file, and the image files that it names, used or
/// not, also those that its key frames name; of a lesson's folder all that its steps read.
[[nodiscard]] std::vector<std::string> filesOf(const SceneArgument& argument, const OpenedScene& opened);

/// The image files that a scene names.
[[nodiscard]] std::vector<std::string> imageFilesOf(const Scene& scene, const ImageSource& images);

/// What any step of a lesson in a folder reads.
[[nodiscard]] std::vector<std::string> filesOfLesson(const lesson::LessonFolder& folder);

/// "cube" of "scenes/cube.texplorer.json".
[[nodiscard]] std::string sceneName(const std::string& file);

/// What it is called in names of files, "{scene}": the example's, the lesson's with its step, the file's
/// without folder and extension.
[[nodiscard]] std::string nameOf(const SceneArgument& argument);

/// For --verbose: the images that were loaded.
void tellOfImages(const ImageSource& images);

/// An error about something in the scene, with the scene's file in front of its place.
[[nodiscard]] Error inScene(const SceneArgument& argument, const Error& error);

} // namespace texplorer::screenshot
