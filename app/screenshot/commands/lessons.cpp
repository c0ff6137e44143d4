#include "app/screenshot/arguments/choice_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/command.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/outputs_apart.h"
#include "app/screenshot/reports/lesson_page.h"
#include "app/ui/language/lesson_catalogue.h"
#include "core/base/file_io.h"
#include "core/base/printable.h"
#include "core/lesson/lesson_scene.h"
#include "core/lesson/reason.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

struct LessonsOptions {
    bool json = false;
    std::string checked;
    std::string page;
    std::string language = "en";
    std::vector<std::string> lessons; ///< of the page; none: all
    const Option* pageOption = nullptr;
    const Option* checkOption = nullptr;
};

std::string taskOf(const lesson::Step& step) {
    constexpr std::array<const char*, 4> names{"read", "try", "predict", "match"};
    return names[step.task.index()];
}

Result<std::string> lessonsText() {
    std::string text;
    for (const std::string& name : lesson::builtInLessons()) {
        const Result<lesson::Lesson> found = lesson::LessonFolder::builtIn(name).and_then(lesson::readLesson);
        if (!found)
            return fail(found.error());
        text += fmt::format("{}{}: {}\n  {}\n", text.empty() ? "" : "\n", name, found->title, found->about);
        for (std::size_t i = 0; i < found->steps.size(); ++i)
            text += fmt::format("  {:2} {} ({})\n", i + 1, found->steps[i].title, taskOf(found->steps[i]));
    }
    return text;
}

/// What a step asks, with the numbers of its reason.
Result<Json> taskJson(const lesson::Step& step, const lesson::LessonFolder& folder,
                      const lesson::Lesson& lesson, std::size_t index) {
    Json task = Json::object();
    if (const auto* attempt = std::get_if<lesson::Try>(&step.task))
        task["try"] = attempt->task;
    if (const auto* match = std::get_if<lesson::Match>(&step.task))
        task["match"] = match->task;
    const auto* predict = std::get_if<lesson::Predict>(&step.task);
    if (!predict)
        return task;
    const Result<std::string> reason =
        startOf(folder, lesson, index)
            .and_then([&](const lesson::LessonScene& start) {
                return withEdits(start, predict->answers[predict->right].edits);
            })
            .and_then([&](const lesson::LessonScene& scene) {
                return reasonOf(predict->reason, scene, step.look.probeX, step.look.probeY);
            });
    if (!reason)
        return fail(reason.error());
    task["question"] = predict->question;
    for (const lesson::Answer& answer : predict->answers)
        task["answers"].push_back(answer.text);
    task["right"] = predict->right;
    task["reason"] = *reason;
    return task;
}

Result<std::string> lessonsJson() {
    Json list = Json::array();
    for (const std::string& name : lesson::builtInLessons()) {
        const Result<lesson::LessonFolder> folder = lesson::LessonFolder::builtIn(name);
        const Result<lesson::Lesson> found = folder.and_then(lesson::readLesson);
        if (!found)
            return fail(found.error());
        Json steps = Json::array();
        for (std::size_t i = 0; i < found->steps.size(); ++i) {
            const lesson::Step& step = found->steps[i];
            const Result<Json> task = taskJson(step, *folder, *found, i);
            if (!task)
                return fail(task.error());
            steps.push_back({{"title", step.title}, {"text", step.text}, {"task", taskOf(step)}});
            steps.back().update(*task);
        }
        list.push_back({{"name", name},
                        {"title", found->title},
                        {"source", found->source},
                        {"about", found->about},
                        {"steps", std::move(steps)}});
    }
    return Json{{"lessons", std::move(list)}}.dump(2) + "\n";
}

/// What was found in a lesson; errors stay sentences on standard error.
ExitCode printProblems(const std::string& file, const std::vector<Error>& problems, std::size_t steps) {
    Json list = Json::array();
    for (const Error& problem : problems)
        list.push_back({{"where", problem.where}, {"sentence", problem.message}});
    const Result<void> printed =
        print(documentText({{"file", file}, {"steps", steps}, {"problems", std::move(list)}}));
    return printed ? problems.empty() ? success : failure : complain(printed.error());
}

ExitCode check(const std::string& path, bool json) {
    const lesson::LessonFolder folder = lesson::LessonFolder::onDisk(path);
    const Result<lesson::Lesson> found = readLesson(folder);
    if (!found) {
        const ExitCode status = complain(found.error());
        return json ? printProblems(found.error().where, {found.error()}, 0) : status;
    }
    std::vector<Error> problems = checkLesson(folder, *found);
    for (const ui::LanguageRow& row : ui::languageRows) {
        if (const auto catalogue = readLessonCatalogue(folder, row.language); !catalogue)
            problems.push_back(catalogue.error());
    }
    const std::string file = (folder.path() / lesson::lessonFileName).string();
    for (const Error& problem : problems)
        (void)complain({problem.code, describe(problem), file});
    if (json)
        return printProblems(file, problems, found->steps.size());
    if (!problems.empty())
        return failure;
    const Result<void> written =
        print(fmt::format("{}: {} steps, nothing is wrong\n", printable(file), found->steps.size()));
    return written ? success : complain(written.error());
}

std::vector<std::string> pageLanguages() {
    std::vector<std::string> names;
    for (const ui::LanguageRow& row : ui::languageRows)
        if (row.language != ui::Language::System) // a page is for others
            names.emplace_back(row.name);
    return names;
}

Result<ui::LanguageRow> languageNamed(const std::string& name) {
    const std::vector<std::string> names = pageLanguages();
    if (std::ranges::find(names, name) != names.end())
        return *std::ranges::find(ui::languageRows, name, &ui::LanguageRow::name);
    return refuseChoice(fmt::format("{}", fmt::join(names, ", ")), name, "--language");
}

/// With commas between them, but for a folder that has one in its name.
std::vector<std::string> namedIn(const std::vector<std::string>& values) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const std::string& value : values) {
        if (std::filesystem::is_directory(value, ignored)) {
            names.push_back(value);
            continue;
        }
        for (std::size_t from = 0; from <= value.size();) {
            const std::size_t end = std::min(value.find(',', from), value.size());
            names.push_back(value.substr(from, end - from));
            from = end + 1;
        }
    }
    return names;
}

Result<std::vector<lesson::LessonFolder>> foldersOfPage(const LessonsOptions& options) {
    std::vector<lesson::LessonFolder> folders;
    for (const std::string& name :
         options.lessons.empty() ? lesson::builtInLessons() : namedIn(options.lessons)) {
        Result<lesson::LessonFolder> folder = lessonFolder(name);
        if (!folder)
            return fail(folder.error().code, folder.error().message, "--lesson");
        folders.push_back(*std::move(folder));
    }
    return folders;
}

ExitCode writePage(const LessonsOptions& options) {
    const Result<ui::LanguageRow> language = languageNamed(options.language);
    if (!language)
        return complain(language.error(), wrongCall);
    Result<std::vector<lesson::LessonFolder>> folders = foldersOfPage(options);
    if (!folders)
        return complain(folders.error(), wrongCall);
    if (const Result<void> possible = checkFolderWritable(options.page); !possible)
        return complain(possible.error());
    if (const Result<void> free = checkPageFolder(options.page); !free)
        return complain(free.error());
    std::vector<std::string> read;
    for (const lesson::LessonFolder& folder : *folders)
        std::ranges::move(filesOfLesson(folder), std::back_inserter(read));
    LongWork work("texshot: drawing the lessons");
    const Result<std::vector<PageFile>> files =
        lessonPage({.folders = *std::move(folders),
                    .language = language->language,
                    .progress = [&work](float done) { work.report(done); },
                    .stop = work.stopToken()});
    work.finish();
    if (work.stopToken().stop_requested())
        return complainInterrupted();
    if (!files)
        return complain(files.error());
    std::vector<FileContent> contents;
    std::vector<NamedOutput> outputs;
    for (const PageFile& file : *files) {
        contents.push_back({file.name, file.bytes});
        outputs.push_back({"--page", (std::filesystem::path(options.page) / file.name).string()});
    }
    if (const Result<void> apart = checkOutputsApart(outputs, read); !apart)
        return complain(apart.error(), wrongCall);
    std::optional<Uninterrupted> placing;
    const Result<void> written =
        writeFolderAtomically(options.page, contents, [&placing] { placing.emplace(); });
    return written ? success : complain(written.error());
}

ExitCode lessons(const LessonsOptions& options) {
    if (options.checkOption->isGiven() && options.pageOption->isGiven())
        return complain(
            {ErrorCode::OutOfRange, "one is checked or shown, not both at once", "--check, --page"},
            wrongCall);
    if (!options.checked.empty())
        return check(options.checked, options.json);
    if (options.pageOption->isGiven())
        return writePage(options);
    const Result<void> written = (options.json ? lessonsJson() : lessonsText()).and_then(print);
    return written ? success : complain(written.error());
}

} // namespace

void addLessons(CommandLine& line) {
    Command& command = line.command("lessons", "The lessons and their steps, or what is wrong with one.");
    auto options = std::make_shared<LessonsOptions>();
    const Option& json =
        command.flag("--json", options->json,
                     "As JSON, for programs: \"lessons\" (name, title, source, about, steps); with "
                     "--check \"file\", \"steps\" and \"problems\" (where, sentence).");
    const Option& check =
        command.option("--check", options->checked,
                       "Look for mistakes in a lesson's folder: every scene is opened, every answer drawn.",
                       {.value = "DIR"});
    const Option& page = command.option(
        "--page", options->page,
        "Write the lessons as a page for a browser or a printer into a folder: index.html with every step, "
        "question and answer, beside it the pictures, and below programs/ those of each step.",
        {.value = "DIR", .excludes = &json});
    options->pageOption = &page;
    options->checkOption = &check;
    command.option(
        "--lesson", options->lessons,
        "On the page only this one, by its name or its folder; or several, with commas. May be given again.",
        {.value = "NAME", .oneEach = true, .needs = &page, .offers = {lesson::builtInLessons}});
    command.option("--language", options->language,
                   fmt::format("The page's: one of {}. Where a lesson has no translation it stays English.",
                               fmt::join(pageLanguages(), ", ")),
                   {.value = "LANGUAGE", .needs = &page, .offers = {pageLanguages}});
    command.footer(
        "\"texshot shot --lesson NAME --step N\" draws a step. CONTRIBUTING.md says how a lesson is written.\n"
        "On the page a step's program is folded, and the calls that it is about stand beside its text. The files are "
        "those of \"texshot emit --lesson NAME --step N --files\", for each --as that can say the scene; the page "
        "says why another one can't. Printed on A4 or Letter, each lesson begins a page, without the folded programs, "
        "and the answers are on the last pages.\n"
        "Exit status: 0 done, 1 something is wrong with the lesson, 2 a wrong call.");
    command.onCall([options] { return lessons(*options); });
}

} // namespace texplorer::screenshot
