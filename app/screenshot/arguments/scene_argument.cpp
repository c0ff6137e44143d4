#include "app/screenshot/arguments/scene_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/output/messages.h"
#include "app/ui/language/lesson_catalogue.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/example.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/edit/edit.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_listing.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/storage/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace texplorer::screenshot {
namespace {

Result<void> assign(Scene& scene, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    const Edit edit = edit::Set{assignment.substr(0, equals), assignment.substr(equals + 1)};
    return makeEdits(scene, {&edit, 1});
}

/// Whether a model's vertices, which an assignment may change, are in a file.
bool hasMeshFiles(const Scene& scene) {
    return std::ranges::any_of(scene.models, [](const Model& model) { return !model.mesh.file.empty(); });
}

/// Told while the command line is read, before a value that stands apart is taken for a scene's file.
Sentence checkAssignment(const std::string& text) {
    return text.find('=') != std::string::npos
               ? Sentence()
               : Sentence("expected PATH=VALUE, joined by = without a space, found \"{0}\"",
                          ProperName{text});
}

/// How much is read of an input that should hold a scene: of a PNG, which has its pixels beside it, all.
std::size_t maxBytesOf(const std::string& path) {
    std::error_code ignored;
    if (isObjName(path))
        return maxObjBytes;
    if (isStandardInput(path) || !std::filesystem::is_regular_file(path, ignored))
        return maxSceneBytes;
    constexpr std::size_t begin = 8; // as long as the signature of a PNG
    const Result<Bytes> start = readFileStart(path, begin);
    return start ? maxSceneFileBytes(*start) : maxSceneBytes;
}

Result<SceneContent> readSceneInput(const SceneArgument& argument) {
    const std::string& path = argument.file;
    const Result<Bytes> file = readInput(path, maxBytesOf(path));
    if (!file)
        return fail(file.error());
    Result<SceneContent> read =
        isObjInput(path, *file)
            ? meshFileIn(*file, argument.path()).and_then([&](MeshFile&& meshes) {
                  return sceneOfObj(std::move(meshes), argument.path().filename().string());
              })
            : sceneTextIn(*file).map([](std::string&& text) { return SceneContent{std::move(text)}; });
    if (!read)
        return fail(inScene(argument, read.error()));
    for (const Sentence& note : read->notes)
        warn(inScene(argument, {ErrorCode::Unsupported, note, {}}));
    return read;
}

Result<Scene> exampleNamed(const std::string& name) {
    Result<Scene> scene = exampleScene(name + ".json");
    return scene ? scene : fail(scene.error().code, scene.error().message, atOption("--example"));
}

Result<void> applyPresetNamed(Scene& scene, const std::string& name) {
    const Preset* preset = findPreset(name);
    if (preset)
        return applyPreset(*preset, scene);
    return refuseChoice(namesIn(presets()), name, "--preset");
}

Result<lesson::LessonScene> sceneOfTask(const SceneArgument& argument, const lesson::Step& step,
                                        const lesson::LessonScene& start) {
    const auto* predict = std::get_if<lesson::Predict>(&step.task);
    const auto* match = std::get_if<lesson::Match>(&step.task);
    if (argument.reached && match)
        return lesson::withEdits(start, match->edits);
    if (argument.reached)
        return fail(ErrorCode::OutOfRange, "this step has no picture to reach", atOption("--reached"));
    const std::size_t answers = predict ? predict->answers.size() : 0;
    if (argument.answer > answers)
        return fail(ErrorCode::OutOfRange,
                    answers > 0 ? Sentence("this step has {0} answers", answers) : "this step has no answers",
                    atOption("--answer"));
    return argument.answer > 0 ? lesson::withEdits(start, predict->answers[argument.answer - 1].edits)
                               : Result<lesson::LessonScene>(start);
}

tl::expected<OpenedScene, SceneProblem> openStep(const SceneArgument& argument) {
    const auto problem = [](const Error& error, ExitCode code) {
        return tl::unexpected(SceneProblem{error, code});
    };
    const Result<lesson::LessonFolder> folder = lessonFolder(argument.lesson);
    if (!folder)
        return problem({folder.error().code, folder.error().message, atOption("--lesson")}, wrongCall);
    const Result<lesson::Lesson> lesson = readLesson(*folder);
    if (!lesson)
        return problem(lesson.error(), failure);
    if (argument.step > lesson->steps.size())
        return problem(
            {ErrorCode::OutOfRange,
             Sentence("expected a step from 1 to {0}, found {1}", lesson->steps.size(), argument.step),
             atOption("--step")},
            wrongCall);
    const Result<lesson::LessonScene> start =
        startOf(*folder, *lesson, argument.step - 1, lesson::StepImages::Read, argument.units);
    if (!start)
        return problem(within(inFile(folder->placeOf(lesson::lessonFileName)), start.error()), failure);
    Result<lesson::LessonScene> scene = sceneOfTask(argument, lesson->steps[argument.step - 1], *start);
    if (!scene)
        return problem(scene.error(), wrongCall);
    if (!scene->fallback.empty())
        warn({ErrorCode::Unsupported, scene->fallback, atOption("--lesson")});
    return OpenedScene{std::move(scene->scene), std::move(scene->images)};
}

} // namespace

std::vector<std::string> imageFilesOf(const Scene& scene, const ImageSource& images) {
    std::vector<std::string> files;
    for (const FileName& named : fileNamesOf(scene))
        if (!named.file.empty() && !images.fileInMemory(named.file))
            files.push_back((images.directory() / named.file).string());
    return files;
}

std::vector<std::string> filesOfLesson(const lesson::LessonFolder& folder) {
    if (folder.path().empty()) // one of the program's
        return {};
    std::vector<std::string> files{(folder.path() / lesson::lessonFileName).string()};
    for (const ui::LanguageRow& row : ui::languageRows)
        files.push_back((folder.path() / ui::catalogueFileOf(row.language)).string());
    const Result<lesson::Lesson> lesson = readLesson(folder);
    for (std::size_t i = 0; lesson && i < lesson->steps.size(); ++i) {
        if (!lesson->steps[i].scene.empty())
            files.push_back((folder.path() / lesson->steps[i].scene).string());
        if (const Result<lesson::LessonScene> start = startOf(folder, *lesson, i))
            for (const FileName& named : fileNamesOf(start->scene))
                if (!named.file.empty())
                    files.push_back((folder.path() / named.file).string());
    }
    return files;
}

std::vector<Assigned> assignedParams() {
    std::vector<Assigned> assigned;
    forEachNewParam([&assigned](const std::string& path, const ParamRow& row, const Value& /*initial*/) {
        if (isList(row.kind))
            return; // who would type that
        assigned.push_back({path, row.kind == Kind::Bool ? std::vector<std::string>{"true", "false"}
                                                         : namesIn(row.choices)});
    });
    return assigned;
}

std::vector<std::string> exampleNames() {
    std::vector<std::string> names;
    for (const Example& each : examples())
        names.push_back(std::filesystem::path(each.file).stem().string());
    return names;
}

Result<lesson::LessonFolder> lessonFolder(const std::string& name) {
    std::error_code ignored;
    if (std::filesystem::is_directory(name, ignored))
        return lesson::LessonFolder::onDisk(name);
    return lesson::LessonFolder::builtIn(name);
}

const Option& addSceneArgument(Command& command, SceneArgument& argument, std::vector<std::string>* files) {
    constexpr const char* help =
        "A scene file (JSON), a PNG drawn by texshot, which contains its scene, or meshes in a file NAME.obj; - "
        "for one of them on standard input. "
        "Default: Texplorer's start scene, a cube and a sphere.";
    const Option& file = files ? command.option("SCENE", *files, help + std::string(" There may be several."))
                               : command.option("SCENE", argument.file, help);
    command.option(
        "--example", argument.example,
        fmt::format("Instead of a scene: a built-in example, one of {}.", fmt::join(exampleNames(), ", ")),
        {.value = "NAME", .excludes = &file, .offers = {exampleNames}});
    command.option(
        "--set", argument.assignments,
        "Change one parameter, as in 'textures[0].minFilter=GL_NEAREST' (quoted because of the "
        "brackets); [+] for an index appends an element. Can be repeated; \"texshot params\" lists "
        "every path.",
        {.value = "PATH=VALUE",
         .oneEach = true,
         .check = checkAssignment,
         .offers = {.assigned = assignedParams}});
    command.option(
        "--preset", argument.presets,
        "A preset such as alpha-test, applied after every --set; or several, separated by commas. Can be "
        "repeated; \"texshot presets\" lists them.",
        {.value = "PRESET", .oneEach = true, .offers = {[] { return namesIn(presets()); }, true}});
    return file;
}

void addSceneOrLessonArgument(Command& command, SceneArgument& argument, std::vector<std::string>* files) {
    const Option& file = addSceneArgument(command, argument, files);
    const Option& lesson =
        command.option("--lesson", argument.lesson,
                       "Instead of a scene: a step of a lesson, by its name (\"texshot lessons\" lists "
                       "them) or its folder.",
                       {.value = "NAME", .excludes = &file, .offers = {lesson::builtInLessons}});
    command.number("--step", argument.step, 1, lesson::maxSteps, "The step of the lesson.",
                   {.needs = &lesson});
    const Option& answer =
        command.number("--answer", argument.answer, 1, lesson::maxAnswers,
                       "Draw the picture of this answer to the step's question.", {.needs = &lesson});
    command.flag("--reached", argument.reached, "Draw the picture to reach in the step.",
                 {.needs = &lesson, .excludes = &answer});
}

tl::expected<OpenedScene, SceneProblem> openScene(const SceneArgument& argument) {
    OpenedScene opened{defaultScene(), ImageSource{}};
    if (!argument.example.empty() && !argument.lesson.empty())
        return tl::unexpected(SceneProblem{
            {ErrorCode::OutOfRange, N_("--example and --lesson exclude each other"), {}}, wrongCall});
    if (!argument.example.empty()) {
        Result<Scene> scene = exampleNamed(argument.example);
        if (!scene)
            return tl::unexpected(SceneProblem{scene.error(), wrongCall});
        opened.scene = *std::move(scene);
    }
    if (!argument.lesson.empty()) {
        auto step = openStep(argument);
        if (!step)
            return step;
        opened = *std::move(step);
    }
    if (!argument.file.empty()) {
        Result<SceneContent> read = readSceneInput(argument);
        if (!read)
            return tl::unexpected(SceneProblem{read.error(), failure});
        Result<Scene> scene = parseScene(read->text);
        if (!scene)
            return tl::unexpected(SceneProblem{inScene(argument, scene.error()), failure});
        opened = {*std::move(scene), ImageSource{argument.path().parent_path()}};
        if (read->meshes) {
            opened.libraries = read->meshes->libraries;
            opened.images.put(argument.path().filename().string(), std::move(read->meshes));
        }
    }
    if (!argument.assignments.empty() && hasMeshFiles(opened.scene))
        static_cast<void>(
            opened.images.load(opened.scene)); // who needs the files says what is wrong with them
    for (const std::string& assignment : argument.assignments) {
        if (const auto assigned = assign(opened.scene, assignment); !assigned)
            return tl::unexpected(SceneProblem{assigned.error(), wrongCall});
    }
    for (const std::string& preset : argument.presets) {
        if (const auto applied = applyPresetNamed(opened.scene, preset); !applied)
            return tl::unexpected(SceneProblem{applied.error(), wrongCall});
    }
    opened.images.setLimits(argument.limits);
    return opened;
}

std::vector<std::string> filesOf(const SceneArgument& argument, const OpenedScene& opened) {
    std::vector<std::string> files = imageFilesOf(opened.scene, opened.images);
    if (!argument.lesson.empty())
        if (const Result<lesson::LessonFolder> folder = lessonFolder(argument.lesson))
            std::ranges::move(filesOfLesson(*folder), std::back_inserter(files));
    files.push_back(argument.file);
    for (const std::filesystem::path& library : opened.libraries)
        files.push_back(library.string());
    return files;
}

std::filesystem::path SceneArgument::path() const {
    return isStandardInput(file) ? std::filesystem::path() : std::filesystem::path(file);
}

std::string sceneName(const std::string& file) {
    if (file.empty())
        return "scene";
    std::filesystem::path name = std::filesystem::path(file).stem();
    if (name.extension() == ".texplorer")
        name = name.stem();
    return name.string();
}

std::string nameOf(const SceneArgument& argument) {
    if (!argument.example.empty())
        return argument.example;
    if (argument.lesson.empty())
        return sceneName(argument.file);
    return fmt::format("{}-{}", std::filesystem::path(argument.lesson).filename().string(), argument.step);
}

void tellOfImages(const ImageSource& images) {
    for (const std::string& file : images.files()) {
        const auto image = images.contentOf(file);
        if (!image || image->surfaces.empty())
            continue;
        const Surface& base = image->surface(0, 0);
        tell(fmt::format("read {}, {}, {} × {}", file, image->format, widthOf(base), heightOf(base)));
    }
}

Error inScene(const SceneArgument& argument, const Error& error) {
    return argument.file.empty() ? error : within(inFile(inputName(argument.file)), error);
}

} // namespace texplorer::screenshot
