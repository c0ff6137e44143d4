#include "app/screenshot/reports/program_text.h"

#include "core/lesson/lesson.h"

#include <fmt/core.h>

#include <filesystem>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

/// What a lesson's step says, and what it is about.
Result<void> tellOfStep(const SceneArgument& argument, emit::ProgramOptions& options) {
    const Result<lesson::LessonFolder> folder = lessonFolder(argument.lesson);
    if (!folder)
        return fail(folder.error());
    const Result<lesson::Lesson> lesson = readLesson(*folder);
    if (!lesson)
        return fail(lesson.error());
    const lesson::Step& step = lesson->steps.at(argument.step - 1);
    options.title = fmt::format("{}: {}", lesson->title, step.title);
    options.about = step.text;
    if (!step.look.param.empty())
        options.explained.insert(step.look.param);
    for (const lesson::Edit& edit : step.edits) {
        if (!edit.path.empty())
            options.explained.insert(edit.path);
    }
    return {};
}

} // namespace

tl::expected<std::vector<emit::Line>, SceneProblem>
programOf(const SceneArgument& argument, emit::Flavour flavour, emit::ProgramOptions options) {
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
    options.fileName = [&](const std::string& file) {
        std::error_code ignored; // where the current folder was removed, a relative name stays one
        const fs::path here = fs::current_path(ignored);
        const fs::path whole = (here / opened->images.directory() / file).lexically_normal();
        const fs::path relative = whole.lexically_relative((here / place).lexically_normal());
        const bool below = !relative.empty() && *relative.begin() != "..";
        return (below ? relative : whole).generic_string();
    };
    emit::TextureCodes codes;
    auto lines = emit::program(flavour, opened->scene, opened->images, options, codes);
    if (!lines)
        return problem(lines.error());
    return *std::move(lines);
}

} // namespace texplorer::screenshot
