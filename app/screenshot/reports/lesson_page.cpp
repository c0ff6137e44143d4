#include "app/screenshot/reports/lesson_page.h"

#include "app/screenshot/reports/handout_style.h"
#include "app/screenshot/reports/lesson_step.h"
#include "app/ui/language/lesson_catalogue.h"
#include "texplorer/base/parallel.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/base/tried.h"
#include "texplorer/files/file_io.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr std::string_view indexName = "index.html";
/// What tells a page of ours from others' files.
constexpr std::string_view pageMark = R"(<meta name="generator" content="texshot lessons">)";
constexpr std::size_t markedBytes = 512; ///< of the page's, within which the mark stands
/// The page needs its pictures and its style, and nothing that a lesson's text could bring.
constexpr std::string_view pagePolicy =
    R"(<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' file: data:; )"
    R"(style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'">)";

/// What HTML calls a language: "zh-CN".
std::string tagOf(ui::Language language) {
    std::string tag(rowOf(language).name);
    std::ranges::replace(tag, '_', '-');
    return tag;
}

/// A folder may be called anything, and another one the same: this is fit for files' names and links.
std::string anchorOf(const lesson::LessonFolder& folder, std::size_t number, std::set<std::string>& taken) {
    const auto isPlain = [](char each) {
        return (each >= 'a' && each <= 'z') || (each >= '0' && each <= '9') || each == '-';
    };
    std::string anchor = folder.name();
    if (anchor.empty() || anchor.front() == '-' || anchor.size() > 64 ||
        !std::ranges::all_of(anchor, isPlain))
        anchor = fmt::format("lesson-{}", number);
    while (!taken.insert(anchor).second)
        anchor += "-again";
    return anchor;
}

Result<std::vector<PageLesson>> readLessons(const LessonPageOptions& options, const ui::Catalogue* words) {
    std::vector<PageLesson> lessons;
    std::set<std::string> taken;
    for (const lesson::LessonFolder& folder : options.folders) {
        Result<lesson::Lesson> found = readLesson(folder);
        if (!found)
            return fail(found.error());
        Result<std::shared_ptr<const ui::Catalogue>> texts = readLessonCatalogue(folder, options.language);
        if (!texts)
            return fail(texts.error());
        lessons.push_back({folder,
                           *std::move(found),
                           anchorOf(folder, lessons.size() + 1, taken),
                           {words, *std::move(texts)},
                           options.window.empty() || !folder.path().empty() // the window has only its own
                               ? std::string()
                               : fmt::format("{}#lesson={}", options.window, folder.name())});
    }
    return lessons;
}

struct StepPlace {
    std::size_t lesson;
    std::size_t step;
};

std::vector<StepPlace> placesOf(const std::vector<PageLesson>& lessons) {
    std::vector<StepPlace> places;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        for (std::size_t step = 0; step < lessons[i].lesson.steps.size(); ++step)
            places.push_back({i, step});
    }
    return places;
}

/// All steps, side by side, in their order. After the first one that fails no other is begun.
Result<std::vector<PageStep>> writeSteps(const LessonPageOptions& options,
                                         const std::vector<PageLesson>& lessons,
                                         const std::vector<StepPlace>& places) {
    std::vector<std::optional<Result<PageStep>>> steps(places.size());
    std::atomic<bool> hasFailed = false;
    std::atomic<std::size_t> done = 0;
    parallelFor(places.size(), processorThreads(), [&](std::size_t i) {
        if (hasFailed || options.stop.stop_requested())
            return;
        constexpr FailureWords words{N_("not enough memory for the lessons"),
                                     N_("the lessons can't be written")};
        steps[i] =
            tried(words, [&] { return pageStep(lessons[places[i].lesson], places[i].step, options.stop); });
        if (!*steps[i])
            hasFailed = true;
        if (options.progress)
            options.progress(static_cast<float>(++done) / static_cast<float>(places.size()));
    });
    std::vector<PageStep> written;
    for (std::optional<Result<PageStep>>& step : steps) {
        if (step && !*step)
            return fail(step->error());
    }
    if (options.stop.stop_requested())
        return fail(ErrorCode::Cancelled, "the work was stopped");
    for (std::optional<Result<PageStep>>& step : steps)
        written.push_back(**std::move(step));
    return written;
}

/// Puts the pages together.
class PageWriter {
public:
    PageWriter(const LessonPageOptions& options, const std::vector<PageLesson>& lessons,
               const PageWords& words)
        : options_(options)
        , lessons_(lessons)
        , words_(words) {}

    Result<std::vector<PageFile>> write(const std::vector<StepPlace>& places, std::vector<PageStep> steps) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i].step == 0)
                beginLesson(places[i].lesson);
            sections_ += steps[i].section;
            answers_ += steps[i].answer;
            for (PageFile& file : steps[i].files) {
                if (const Result<void> added = add(std::move(file)); !added)
                    return fail(added.error());
            }
            if (places[i].step + 1 == lessons_[places[i].lesson].lesson.steps.size())
                endLesson(places[i].lesson);
        }
        const std::string page = whole();
        const ByteView bytes = viewBytes(page);
        files_.push_back({std::string(indexName), Bytes(bytes.begin(), bytes.end())});
        return std::move(files_);
    }

private:
    /// A file that several programs read is there once.
    Result<void> add(PageFile file) {
        const auto [known, isNew] = places_.try_emplace(file.name, files_.size());
        if (isNew)
            files_.push_back(std::move(file));
        else if (files_[known->second].bytes != file.bytes)
            return fail(ErrorCode::Unsupported, "two files of the page have this name", inFile(file.name));
        return {};
    }

    /// Whether it is a page of several lessons, with their list.
    [[nodiscard]] bool isBook() const { return lessons_.size() > 1; }

    [[nodiscard]] static std::string titleOf(const PageLesson& lesson) {
        return lesson.words.textHtml(lesson.lesson.title);
    }

    void beginLesson(std::size_t index) {
        const PageLesson& lesson = lessons_[index];
        const std::string about = lesson.words.textHtml(lesson.lesson.about);
        contents_ +=
            fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", lesson.anchor, titleOf(lesson), about);
        sections_ += fmt::format("<section class=\"lesson\" id=\"{}\">\n", lesson.anchor);
        if (isBook())
            sections_ += fmt::format("<h2>{}. {}</h2>\n", index + 1, titleOf(lesson));
        sections_ += fmt::format("<p>{}</p>\n", about);
        if (!lesson.lesson.source.empty())
            sections_ +=
                fmt::format("<p class=\"source\">{}</p>\n", lesson.words.textHtml(lesson.lesson.source));
        writeKeys(lesson);
        answers_.clear();
    }

    void endLesson(std::size_t index) {
        sections_ += "</section>\n";
        if (answers_.empty())
            return;
        if (isBook())
            key_ += fmt::format("<h3>{}. {}</h3>\n", index + 1, titleOf(lessons_[index]));
        key_ += answers_;
    }

    void writeKeys(const PageLesson& lesson) {
        if (lesson.lesson.keys.empty())
            return;
        sections_ += fmt::format("<p class=\"source\">{}", words_.wordHtml("Keys in the window:"));
        for (const lesson::LessonKey& key : lesson.lesson.keys)
            sections_ += fmt::format(" <kbd>{}</kbd>&nbsp;{}",
                                     words_.wordHtml(std::string(lesson::signOfKey(key.key))),
                                     lesson.words.textHtml(key.label));
        sections_ += "</p>\n";
    }

    [[nodiscard]] std::string contents() const {
        return isBook() ? fmt::format("<nav aria-label=\"{0}\">\n<h2>{0}</h2>\n<ol>\n{1}</ol>\n</nav>\n",
                                      words_.wordHtml("Contents"), contents_)
                        : std::string();
    }

    /// What stands on the last printed pages, which a teacher keeps.
    [[nodiscard]] std::string key() const {
        return key_.empty()
                   ? std::string()
                   : fmt::format(
                         "<section class=\"key paper\" aria-hidden=\"true\">\n<h2>{}</h2>\n{}</section>\n",
                         words_.wordHtml("Answers"), key_);
    }

    [[nodiscard]] std::string whole() const {
        const std::string title = isBook() ? words_.wordHtml("Lessons") : titleOf(lessons_.front());
        const std::string programs = words_.wordHtml(
            "The programs of each step are in the folder \"programs\"; the first lines of each explain how "
            "to compile it. A ring on a picture marks the pixel of a question. Try the tasks in "
            "Texplorer's window: \"texplorer --lesson NAME\" opens a lesson.");
        const std::string answers = words_.wordHtml("The answers are on the last pages.");
        return fmt::format(
            "<!doctype html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width\">\n{}\n{}\n<title>Texplorer: {}</title>\n"
            "<style>\n{}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n<p>{}</p>\n{}</header>\n{}"
            "<main>\n{}</main>\n{}</body>\n</html>\n",
            tagOf(options_.language), pageMark, pagePolicy, title, handoutStyle().front().text, title,
            programs, key_.empty() ? std::string() : fmt::format("<p class=\"paper\">{}</p>\n", answers),
            contents(), sections_, key());
    }

    const LessonPageOptions& options_;
    const std::vector<PageLesson>& lessons_;
    const PageWords& words_;
    std::string contents_;
    std::string sections_;
    std::string answers_; ///< of the lesson that is being written
    std::string key_;
    std::vector<PageFile> files_;
    std::map<std::string, std::size_t> places_; ///< of each file among them
};

} // namespace

Result<void> checkPageFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::directory_iterator there(folder, error);
    if (error == std::errc::permission_denied)
        return fail(ErrorCode::Unreadable, Sentence("can't be read: {0}", error.message()),
                    inFile(folder.string()));
    if (error || there == std::filesystem::directory_iterator())
        return {}; // what can't be written is said by who writes
    const Result<Bytes> page = readFileStart(folder / indexName, markedBytes);
    if (page && !std::ranges::search(*page, viewBytes(pageMark)).empty())
        return {};
    return fail(ErrorCode::Unwritable,
                "expected a new folder, an empty folder or a page of lessons; found other files, which the "
                "page might overwrite",
                inFile(folder.string()));
}

Result<std::vector<PageFile>> lessonPage(const LessonPageOptions& options) {
    const Result<std::unique_ptr<const ui::Catalogue>> catalogue = ui::catalogueOf(options.language);
    if (!catalogue)
        return fail(catalogue.error());
    const Result<std::vector<PageLesson>> lessons = readLessons(options, catalogue->get());
    if (!lessons)
        return fail(lessons.error());
    const std::vector<StepPlace> places = placesOf(*lessons);
    Result<std::vector<PageStep>> steps = writeSteps(options, *lessons, places);
    if (!steps)
        return fail(steps.error());
    return PageWriter(options, *lessons, {catalogue->get()}).write(places, *std::move(steps));
}

} // namespace texplorer::screenshot
