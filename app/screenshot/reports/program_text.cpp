#include "app/screenshot/reports/program_text.h"

#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/lesson.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/suite/hash.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

/// What a lesson's step says, and what it is about.
void tellOfStep(const lesson::Lesson& lesson, std::size_t index, emit::ProgramOptions& options) {
    const lesson::Step& step = lesson.steps.at(index);
    options.title = fmt::format("{}: {}", lesson.title, step.title);
    options.about = step.text;
    options.explained = subjectsOf(step);
}

Result<void> tellOfStep(const SceneArgument& argument, emit::ProgramOptions& options) {
    const Result<lesson::Lesson> lesson = lessonFolder(argument.lesson).and_then(lesson::readLesson);
    if (!lesson)
        return fail(lesson.error());
    tellOfStep(*lesson, argument.step - 1, options);
    return {};
}

Result<Bytes> bytesOf(const ImageSource& images, const std::string& file) {
    if (const std::shared_ptr<const Bytes> inMemory = images.fileInMemory(file))
        return *inMemory;
    return readFile(images.directory() / file, lesson::maxLessonFileBytes);
}

/// What a file is called beside a program. Those of the program's own lessons, which lie in no folder, keep
/// their names; another's name comes from outside and could be one that a shell or a browser takes for
/// something else.
std::string nameBeside(const ImageSource& images, const std::string& file) {
    if (images.fileInMemory(file))
        return fs::path(file).filename().string();
    const Result<Bytes> bytes = bytesOf(images, file);
    const CodecRow* codec = bytes ? recogniseImage(*bytes) : nullptr;
    if (codec == nullptr) // which is said where it is read
        return "image";
    constexpr std::size_t digits = 8;
    return fmt::format("image-{}{}", suite::hashOf(*bytes).substr(0, digits), extensionsOf(*codec).front());
}

/// With the files that it reads in its own folder.
Result<ProgramText> programBesideFiles(emit::Flavour flavour, const Scene& scene, const ImageSource& images,
                                       emit::ProgramOptions options, emit::TextureCodes& codes) {
    const auto nameOfFile = [&images](const std::string& file) { return nameBeside(images, file); };
    options.fileName = nameOfFile;
    options.readsFilesInMemory = true;
    Result<std::vector<emit::Line>> lines = emit::program(flavour, scene, images, options, codes);
    if (!lines)
        return fail(lines.error());
    ProgramText program{*std::move(lines)};
    for (const std::string& file : filesRead(program.lines, scene)) {
        Result<Bytes> bytes = bytesOf(images, file);
        if (!bytes)
            return fail(bytes.error());
        const std::string name = nameOfFile(file);
        const auto other = std::ranges::find(program.files, name, &ReadFile::name);
        if (other != program.files.end() && other->bytes != *bytes)
            return fail(ErrorCode::Unsupported, "two files of this name can't be in one folder",
                        inFile(name));
        if (other == program.files.end())
            program.files.push_back({name, *std::move(bytes)});
    }
    return program;
}

} // namespace

std::set<std::string, std::less<>> subjectsOf(const lesson::Step& step) {
    std::set<std::string, std::less<>> paths;
    if (!step.look.param.empty())
        paths.insert(step.look.param);
    const std::string camera = keyOf<&Scene::view>() + "."; // a background is no subject
    for (const Edit& edit : step.edits) {
        const std::string_view path = pathOf(edit);
        if (!path.empty() && !path.starts_with(camera))
            paths.emplace(path);
    }
    return paths;
}

Result<ProgramText> programOfStep(const lesson::Lesson& lesson, std::size_t step,
                                  const lesson::LessonScene& scene, emit::Flavour flavour,
                                  const std::string& source, emit::TextureCodes& codes) {
    emit::ProgramOptions options;
    options.source = source;
    tellOfStep(lesson, step, options);
    return programBesideFiles(flavour, scene.scene, scene.images, std::move(options), codes);
}

tl::expected<ProgramText, SceneProblem> programOf(const SceneArgument& argument, emit::Flavour flavour,
                                                  emit::ProgramOptions options, FilePlaces files) {
    const auto problem = [&](const Error& error) {
        return tl::unexpected(SceneProblem{inScene(argument, error), failure});
    };
    auto opened = openScene(argument);
    if (!opened)
        return tl::unexpected(opened.error());
    if (const Result<void> loaded = opened->images.load(opened->scene); !loaded)
        return problem(loaded.error());
    if (!argument.lesson.empty()) {
        if (const Result<void> told = tellOfStep(argument, options); !told)
            return problem(told.error());
    } else if (options.title.empty())
        options.title = nameOf(argument);
    const fs::path place = fs::path(options.source).parent_path();
    options.source = fs::path(options.source).filename().string();
    emit::TextureCodes codes;
    if (files == FilePlaces::Beside) {
        Result<ProgramText> program =
            programBesideFiles(flavour, opened->scene, opened->images, std::move(options), codes);
        if (!program)
            return problem(program.error());
        program->madeFrom = filesOf(argument, *opened);
        return *std::move(program);
    }
    options.fileName = [&](const std::string& file) {
        std::error_code ignored; // where the current folder was removed, a relative name stays one
        const fs::path here = fs::current_path(ignored);
        const fs::path whole = (here / opened->images.directory() / file).lexically_normal();
        const fs::path relative = whole.lexically_relative((here / place).lexically_normal());
        const bool below = !relative.empty() && *relative.begin() != "..";
        return (below ? relative : whole).generic_string();
    };
    auto lines = emit::program(flavour, opened->scene, opened->images, options, codes);
    if (!lines)
        return problem(lines.error());
    return ProgramText{*std::move(lines), {}, filesOf(argument, *opened)};
}

} // namespace texplorer::screenshot
