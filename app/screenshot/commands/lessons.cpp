#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/reports/lesson_page.h"
#include "app/ui/language/lesson_catalogue.h"
#include "app/ui/language/po_file.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/lesson_check.h"
#include "texplorer/lesson/numbers.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

struct LessonsOptions {
    bool json = false;
    std::string checked;
    std::string page;
    std::string translated; ///< the folder whose texts are written as a template
    std::string language = "en";
    std::string window;               ///< of the page: the address that steps link to
    std::vector<std::string> lessons; ///< of the page; none: all
    const Option* pageOption = nullptr;
    const Option* checkOption = nullptr;
    const Option* templateOption = nullptr;
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

/// A step, with the numbers of its texts as a page has them.
Result<Json> stepJson(const lesson::LessonFolder& folder, const lesson::Lesson& lesson, std::size_t index) {
    const lesson::Step& step = lesson.steps[index];
    const Result<lesson::StepNumbers> numbers =
        startOf(folder, lesson, index).and_then([&](const lesson::LessonScene& start) {
            return numbersOf(start, step, lesson::pageSize);
        });
    if (!numbers)
        return fail(numbers.error());
    const lesson::Numbers& start = numbers->start;
    Json json{{"title", step.title}, {"text", start.in(step.text)}, {"task", taskOf(step)}};
    if (step.fallback)
        json["fallback"] = step.fallback->text;
    if (const auto* attempt = std::get_if<lesson::Try>(&step.task))
        json["try"] = start.in(attempt->task);
    if (const auto* match = std::get_if<lesson::Match>(&step.task))
        json["match"] = start.in(match->task);
    if (const auto* predict = std::get_if<lesson::Predict>(&step.task)) {
        json["question"] = start.in(predict->question);
        for (const lesson::Answer& answer : predict->answers)
            json["answers"].push_back(start.in(answer.text));
        json["right"] = predict->right;
        json["reason"] = numbers->answered.in(predict->reason);
    }
    return json;
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
            Result<Json> step = stepJson(*folder, *found, i);
            if (!step)
                return fail(step.error());
            steps.push_back(*std::move(step));
        }
        list.push_back({{"name", name},
                        {"title", found->title},
                        {"source", found->source},
                        {"about", found->about},
                        {"steps", std::move(steps)}});
    }
    return documentText(std::move(list));
}

bool hasLetters(const std::string& text) {
    return std::ranges::any_of(text, [](unsigned char each) { return std::isalpha(each) != 0; });
}

/// What is wrong with the translations beside a lesson: one that can't be read, a text that it hasn't, a text
/// that the lesson hasn't any more. `where` is the file.
std::vector<Error> checkCatalogues(const lesson::LessonFolder& folder, const lesson::Lesson& lesson) {
    const std::vector<std::string> all = textsOf(lesson);
    const std::set<std::string> texts(all.begin(), all.end());
    std::vector<Error> problems;
    for (const ui::LanguageRow& row : ui::languageRows) {
        const auto catalogue = readLessonCatalogue(folder, row.language);
        if (!catalogue)
            problems.push_back(catalogue.error());
        if (!catalogue || !*catalogue)
            continue;
        const std::string file = ui::catalogueFileOf(row.language);
        const std::set<std::string> keys = (*catalogue)->keys();
        for (const std::string& text : texts) {
            if (hasLetters(text) && !keys.contains(text))
                problems.push_back({ErrorCode::NotFound,
                                    Sentence("expected a translation of {0}", inQuotes(text)), inFile(file)});
        }
        for (const std::string& key : keys) {
            if (!texts.contains(key))
                problems.push_back({ErrorCode::NotFound,
                                    Sentence("the lesson no longer has the text {0}", inQuotes(key)),
                                    inFile(file)});
        }
    }
    return problems;
}

ExitCode check(const std::string& path, bool json) {
    const lesson::LessonFolder folder = lesson::LessonFolder::onDisk(path);
    const Result<lesson::Lesson> found = readLesson(folder);
    if (!found)
        return complain(found.error());
    std::vector<Error> problems = checkLesson(folder, *found);
    std::ranges::move(checkCatalogues(folder, *found), std::back_inserter(problems));
    const std::string file = folder.placeOf(lesson::lessonFileName);
    for (const Error& problem : problems)
        (void)complain(within(inFile(file), problem));
    if (!problems.empty() && !json)
        return failure;
    const std::size_t steps = found->steps.size();
    const Result<void> written = print(json ? documentText(Json::array({{{"file", file}, {"steps", steps}}}))
                                            : fmt::format("{}: {}, nothing is wrong\n", printable(file),
                                                          Sentence::plural("{0} step", "{0} steps", steps)));
    if (written && !problems.empty())
        return failure;
    return written ? success : complain(written.error());
}

ExitCode writeTemplate(const std::string& path) {
    const lesson::LessonFolder folder = lesson::LessonFolder::onDisk(path);
    const Result<lesson::Lesson> found = readLesson(folder);
    if (!found)
        return complain(found.error());
    const Result<void> written = print(ui::poTemplate(textsOf(*found), lesson::lessonFileName));
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
    return refuseChoice(names, name, "--language");
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
            return fail(folder.error().code, folder.error().message, atOption("--lesson"));
        folders.push_back(*std::move(folder));
    }
    return folders;
}

/// An address that a link may have: of a page on the web, or relative to the lessons' page.
Result<void> checkWindow(const std::string& address) {
    const bool isPlain = std::ranges::none_of(address, [](unsigned char each) {
        return each <= ' ' || each == '#' || each == '"' || each == '<' || each == '>';
    });
    const bool isLink = std::ranges::any_of(std::array{"http://", "https://", "./", "../"},
                                            [&](const char* start) { return address.starts_with(start); });
    if (isPlain && isLink)
        return {};
    return fail(
        ErrorCode::Malformed,
        Sentence("expected an address without # that begins with https://, http://, ./ or ../, found {0}",
                 inQuotes(address)),
        atOption("--window"));
}

ExitCode writePage(const LessonsOptions& options) {
    if (!options.window.empty()) {
        if (const Result<void> window = checkWindow(options.window); !window)
            return complain(window.error(), wrongCall);
    }
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
                    .window = options.window,
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
    const auto given = std::ranges::count_if(
        std::array{options.checkOption, options.pageOption, options.templateOption}, &Option::isGiven);
    if (given > 1)
        return complain({ErrorCode::OutOfRange, N_("expected one of --check, --page and --template"),
                         atOption("--check, --page, --template")},
                        wrongCall);
    if (options.templateOption->isGiven())
        return writeTemplate(options.translated);
    if (!options.checked.empty())
        return check(options.checked, options.json);
    if (options.pageOption->isGiven())
        return writePage(options);
    const Result<void> written = (options.json ? lessonsJson() : lessonsText()).and_then(print);
    return written ? success : complain(written.error());
}

} // namespace

void addLessons(CommandLine& line) {
    Command& command = line.command("lessons", "List the lessons and their steps, check one, or write them "
                                               "as a page.");
    auto options = std::make_shared<LessonsOptions>();
    const Option& json = command.flag(
        "--json", options->json,
        "As JSON, for programs: name, title, source, about and steps of each lesson; with --check file and "
        "steps, and what is wrong as problems.");
    const Option& check = command.option(
        "--check", options->checked,
        "Find errors in a lesson's folder: opens every scene, draws every answer, probes every mark in "
        "pictures of several sizes and compares every translation with the texts.",
        {.value = "DIR"});
    const Option& page = command.option(
        "--page", options->page,
        "Write the lessons as a page for a browser or a printer into a folder: index.html with every step, "
        "question and answer, next to it the pictures, and in programs/ the programs of each step.",
        {.value = "DIR", .excludes = &json});
    const Option& texts = command.option(
        "--template", options->translated,
        "Write the texts of a lesson's folder as a template for gettext's tools, of which msginit and msgmerge make "
        "translations: zh_CN.po and ru.po next to lesson.json.",
        {.value = "DIR", .excludes = &json});
    options->pageOption = &page;
    options->templateOption = &texts;
    options->checkOption = &check;
    command.option(
        "--lesson", options->lessons,
        "With --page: only this lesson, by its name or its folder; or several, separated by commas. Can be "
        "repeated.",
        {.value = "NAME", .oneEach = true, .needs = &page, .offers = {lesson::builtInLessons}});
    command.option("--language", options->language,
                   fmt::format("The language of the page, one of {}. Lessons without a translation stay "
                               "English.",
                               fmt::join(pageLanguages(), ", ")),
                   {.value = "LANGUAGE", .needs = &page, .offers = {pageLanguages}});
    command.option("--window", options->window,
                   "Link each step to the window in a browser at this address, the folder that \"./dev web\" "
                   "makes: https://example.org/texplorer/. Lessons in folders get no links.",
                   {.value = "URL", .needs = &page});
    command.footer(
        "\"texshot shot --lesson NAME --step N\" draws a step. docs/lessons.md says how a lesson is "
        "written.\n"
        "On the page a step's program is folded, and its relevant calls are next to the text. The files "
        "are those of \"texshot emit --lesson NAME --step N --files\", for each --as that can express the "
        "scene; the page gives the reason for the others. When printed on A4 or Letter, each lesson begins "
        "a page, without the folded programs, and the answers are on the last pages.\n"
        "Exit status: 0 done, 1 something is wrong with the lesson, 2 invalid arguments.");
    command.onCall([options] { return lessons(*options); });
}

} // namespace texplorer::screenshot
