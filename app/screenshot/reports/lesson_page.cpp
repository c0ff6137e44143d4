#include "app/screenshot/reports/lesson_page.h"

#include "app/ui/language/lesson_catalogue.h"
#include "app/ui/model/figures.h"
#include "core/base/file_io.h"
#include "core/base/html.h"
#include "core/base/printable.h"
#include "core/codec/png/png.h"
#include "core/image/convert.h"
#include "core/lesson/match.h"
#include "core/lesson/reason.h"
#include "core/reference/draw.h"
#include "core/reference/false_colors.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace texplorer::screenshot {
namespace {

using lesson::LessonScene;

constexpr int stepWidth = 320; // of a step's picture; others are as the window has them
constexpr int stepHeight = 240;

constexpr std::string_view style = R"(<style>
:root { color-scheme: light dark; --line: #8885; --soft: #8882; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 54rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.25; break-after: avoid; }
.lesson { margin-top: 3rem; border-top: 3px solid var(--line); }
.step { display: flow-root; border-top: 1px solid var(--line); margin-top: 1rem; }
.source { opacity: .75; font-size: .9rem; }
figure { position: relative; margin: .4rem 0; width: fit-content; max-width: 100%; }
.shown { float: inline-end; margin-inline-start: 1.5rem; }
img { display: block; max-width: 100%; height: auto; background: var(--soft); }
.mark { position: absolute; width: 9px; height: 9px; margin: -6px; border: 2px solid #fff; border-radius: 50%;
  outline: 1px solid #000; }
.task { border-inline-start: 4px solid #27a; padding-inline-start: .7rem; }
kbd { border: 1px solid var(--line); border-bottom-width: 2px; border-radius: 4px; padding: 0 .35em; }
.answers { list-style: upper-alpha; }
.pictured { display: flex; flex-wrap: wrap; gap: .3rem 2.2rem; }
.pictured li { width: 192px; }
.paper { display: none; }
@page { size: A4; margin: 16mm; }
@media print {
  :root { color-scheme: light; print-color-adjust: exact; }
  body { font-size: 10.5pt; max-width: none; margin: 0; padding: 0; }
  .lesson { break-before: page; margin-top: 0; border-top: 0; }
  .step, figure, li, .paper { break-inside: avoid; }
  details { display: none; }
  .paper { display: block; }
  .shown img { width: 230px; }
  .pictured { clear: both; gap: .2rem 1.5rem; }
  .pictured li { width: 132px; }
}
</style>
)";

std::string escaped(std::string_view text) {
    return escapedHtml(printable(text, LineBreaks::Keep));
}

/// What HTML calls a language: "zh-CN".
std::string tagOf(ui::Language language) {
    std::string tag(rowOf(language).name);
    std::ranges::replace(tag, '_', '-');
    return tag;
}

std::string translated(const ui::Catalogue* catalogue, const std::string& english) {
    return (catalogue ? catalogue->translate(english) : std::nullopt).value_or(english);
}

/// A folder may be called anything: this is fit for a file's name and a link.
std::string anchorOf(const lesson::LessonFolder& folder, std::size_t number) {
    const auto isPlain = [](char each) {
        return (each >= 'a' && each <= 'z') || (each >= '0' && each <= '9') || each == '-';
    };
    const std::string& name = folder.name();
    return !name.empty() && name.size() <= 64 && std::ranges::all_of(name, isPlain)
               ? name
               : fmt::format("lesson-{}", number);
}

/// One lesson that is being written down.
class LessonWriter {
public:
    LessonWriter(const LessonPageOptions& options, const ui::Catalogue* words, std::size_t number)
        : options_(options)
        , words_(words)
        , folder_(options.folders[number - 1])
        , number_(number)
        , anchor_(anchorOf(folder_, number)) {}

    Result<void> write();

    std::string entry;           ///< of the table of contents
    std::string section;         ///< of the page
    std::vector<PageFile> files; ///< its pictures

private:
    [[nodiscard]] std::string word(const std::string& english) const { return translated(words_, english); }
    [[nodiscard]] std::string text(const std::string& english) const {
        return escaped(translated(texts_.get(), english));
    }

    void writeKeys(const std::vector<lesson::LessonKey>& keys);
    Result<void> writeStep(std::size_t index);
    Result<void> writeTask(const std::monostate& /*task*/) { return {}; }
    Result<void> writeTask(const lesson::Try& task);
    Result<void> writeTask(const lesson::Predict& predict);
    Result<void> writeTask(const lesson::Match& match);
    void writeTaskText(const std::string& kind, const std::string& english);
    /// What one sees when one wants to; on paper it stands there.
    void writeHidden(const std::string& summary, const std::string& html);

    /// The picture becomes a file, and this is how it is shown.
    Result<std::string> image(const std::string& name, const Result<Image>& picture, const std::string& alt);
    [[nodiscard]] Result<Image> shownPicture(const lesson::Look& look) const;

    const LessonPageOptions& options_;
    const ui::Catalogue* words_;
    const lesson::LessonFolder& folder_;
    std::size_t number_;
    std::string anchor_;
    std::shared_ptr<const ui::Catalogue> texts_;
    const lesson::Step* step_ = nullptr;
    std::string place_; ///< "wrap-3"
    LessonScene start_{{}, ImageSource{}};
};

Result<void> LessonWriter::write() {
    const Result<lesson::Lesson> found = readLesson(folder_);
    if (!found)
        return fail(found.error());
    Result<std::shared_ptr<const ui::Catalogue>> texts = readLessonCatalogue(folder_, options_.language);
    if (!texts)
        return fail(texts.error());
    texts_ = *std::move(texts);
    const std::string title = text(found->title);
    entry = fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", anchor_, title, text(found->about));
    section = fmt::format("<section class=\"lesson\" id=\"{}\">\n<h2>{}. {}</h2>\n<p>{}</p>\n", anchor_,
                          number_, title, text(found->about));
    if (!found->source.empty())
        section += fmt::format("<p class=\"source\">{}</p>\n", text(found->source));
    writeKeys(found->keys);
    for (std::size_t i = 0; i < found->steps.size(); ++i) {
        Result<LessonScene> start = startOf(folder_, *found, i);
        if (!start)
            return fail(start.error().code, describe(start.error()),
                        folder_.path().empty() ? folder_.name()
                                               : (folder_.path() / lesson::lessonFileName).string());
        start_ = *std::move(start);
        step_ = &found->steps[i];
        if (const Result<void> written = writeStep(i); !written)
            return written;
        if (options_.progress)
            options_.progress((static_cast<float>(number_ - 1) +
                               static_cast<float>(i + 1) / static_cast<float>(found->steps.size())) /
                              static_cast<float>(options_.folders.size()));
    }
    section += "</section>\n";
    return {};
}

void LessonWriter::writeKeys(const std::vector<lesson::LessonKey>& keys) {
    if (keys.empty())
        return;
    section += fmt::format("<p class=\"source\">{}", escaped(word("Keys in the window:")));
    for (const lesson::LessonKey& key : keys)
        section += fmt::format(" <kbd>{}</kbd>&nbsp;{}",
                               escaped(word(std::string(lesson::signOfKey(key.key)))), text(key.label));
    section += "</p>\n";
}

Result<void> LessonWriter::writeStep(std::size_t index) {
    place_ = fmt::format("{}-{}", anchor_, index + 1);
    const std::string title = translated(texts_.get(), step_->title);
    const Result<std::string> shown = image(
        place_, shownPicture(step_->look), word(fmt::format("The picture of step {}: {}", index + 1, title)));
    if (!shown)
        return fail(shown.error());
    const lesson::Look& look = step_->look;
    const std::string mark = look.probeX < 0
                                 ? std::string()
                                 : fmt::format("<i class=\"mark\" style=\"left:{}%;top:{}%\"></i>",
                                               look.probeX / 10.0, look.probeY / 10.0);
    section += fmt::format("<section class=\"step\" id=\"{}\">\n<h3>{}. {}</h3>\n"
                           "<figure class=\"shown\">{}{}</figure>\n<p>{}</p>\n",
                           place_, index + 1, escaped(title), *shown, mark, text(step_->text));
    const auto* const figure = std::ranges::find(ui::figureRows, look.figure, &ui::FigureRow::name);
    if (figure != ui::figureRows.end())
        section += fmt::format(
            "<p class=\"source\">{}</p>\n",
            escaped(word(fmt::format("In the window this step opens the figure {}.", word(figure->label)))));
    for (const std::string& note : imageNotes(start_))
        section += fmt::format("<p class=\"source\">{}</p>\n", escaped(word(note)));
    if (const Result<void> task =
            std::visit([this](const auto& each) { return writeTask(each); }, step_->task);
        !task)
        return task;
    section += "</section>\n";
    return {};
}

void LessonWriter::writeTaskText(const std::string& kind, const std::string& english) {
    section += fmt::format("<p class=\"task\"><b>{}.</b> {}</p>\n", escaped(word(kind)), text(english));
}

void LessonWriter::writeHidden(const std::string& summary, const std::string& html) {
    const std::string name = escaped(word(summary));
    section += fmt::format("<details><summary>{0}</summary><p>{1}</p></details>\n"
                           "<p class=\"paper\" aria-hidden=\"true\"><b>{0}.</b> {1}</p>\n",
                           name, html);
}

Result<void> LessonWriter::writeTask(const lesson::Try& task) {
    writeTaskText("Try", task.task);
    return {};
}

Result<void> LessonWriter::writeTask(const lesson::Predict& predict) {
    writeTaskText("Predict", predict.question);
    std::string list;
    bool isPictured = false;
    for (std::size_t i = 0; i < predict.answers.size(); ++i) {
        const lesson::Answer& answer = predict.answers[i];
        std::string picture;
        if (!answer.edits.empty()) {
            isPictured = true;
            Result<std::string> shown =
                image(fmt::format("{}-answer-{}", place_, i + 1),
                      withEdits(start_, answer.edits).and_then([this](const LessonScene& scene) {
                          return lesson::drawSmall(scene, options_.stop);
                      }),
                      word(fmt::format("The picture of answer {}", static_cast<char>('A' + i))));
            if (!shown)
                return fail(shown.error());
            picture = *std::move(shown);
        }
        list += fmt::format("<li>{}{}</li>\n", picture, text(answer.text));
    }
    section += fmt::format("<ol class=\"answers{}\">\n{}</ol>\n", isPictured ? " pictured" : "", list);
    const Result<std::string> reason =
        withEdits(start_, predict.answers[predict.right].edits).and_then([&](const LessonScene& scene) {
            return reasonOf(translated(texts_.get(), predict.reason), scene, step_->look.probeX,
                            step_->look.probeY);
        });
    if (!reason)
        return fail(reason.error());
    writeHidden("The right answer",
                fmt::format("{}. {}", static_cast<char>('A' + predict.right), escaped(*reason)));
    return {};
}

Result<void> LessonWriter::writeTask(const lesson::Match& match) {
    writeTaskText("Match", match.task);
    const Result<std::string> shown =
        image(place_ + "-reached", withEdits(start_, match.edits).and_then([this](const LessonScene& scene) {
            return lesson::drawSmall(scene, options_.stop);
        }),
              word("The picture to reach"));
    if (!shown)
        return fail(shown.error());
    section += fmt::format("<figure>{}</figure>\n", *shown);
    std::string edits;
    for (const lesson::Edit& edit : match.edits)
        edits +=
            fmt::format("{}<code>{}</code>", edits.empty() ? "" : ", ",
                        escaped(edit.path.empty() ? "preset:" + edit.value : edit.path + "=" + edit.value));
    writeHidden("What leads there", edits);
    return {};
}

/// As the step shows it: false colours where the window has them.
Result<Image> LessonWriter::shownPicture(const lesson::Look& look) const {
    const reference::DrawRequest request{start_.scene, start_.images, 0, stepWidth, stepHeight};
    reference::DrawOptions drawing;
    drawing.stop = options_.stop;
    const EnumRow* row = findRow(EnumTable<reference::Shown>::rows, look.shown);
    const auto shown = row ? static_cast<reference::Shown>(row->value) : reference::Shown::Picture;
    if (shown == reference::Shown::Picture)
        return reference::drawReference(request, drawing).map([](Frame frame) {
            return withoutAlpha(std::move(frame.image)); // the page must not shine through it
        });
    return reference::levelMap(request, {}, drawing).map([shown](const reference::LevelMap& map) {
        return reference::falseColors(map, shown);
    });
}

Result<std::string> LessonWriter::image(const std::string& name, const Result<Image>& picture,
                                        const std::string& alt) {
    if (!picture)
        return fail(picture.error());
    Result<Bytes> bytes = encodePng(*picture);
    if (!bytes)
        return fail(bytes.error());
    files.push_back({name + ".png", *std::move(bytes)});
    return fmt::format("<img src=\"{}.png\" alt=\"{}\" width=\"{}\" height=\"{}\">", name, escaped(alt),
                       picture->width, picture->height);
}

} // namespace

Result<std::vector<PageFile>> lessonPage(const LessonPageOptions& options) {
    const Result<std::unique_ptr<const ui::Catalogue>> words = ui::catalogueOf(options.language);
    if (!words)
        return fail(words.error());
    std::string contents;
    std::string sections;
    std::vector<PageFile> files;
    for (std::size_t number = 1; number <= options.folders.size(); ++number) {
        LessonWriter writer(options, words->get(), number);
        if (const Result<void> written = writer.write(); !written)
            return fail(written.error());
        contents += writer.entry;
        sections += writer.section;
        std::ranges::move(writer.files, std::back_inserter(files));
    }
    const auto word = [&](const std::string& english) { return escaped(translated(words->get(), english)); };
    const std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"{0}\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Texplorer: {1}</title>\n{2}</head>\n"
        "<body>\n<h1>{1}</h1>\n<nav aria-label=\"{3}\">\n<h2>{3}</h2>\n<ol>\n{4}</ol>\n</nav>\n"
        "<main>\n{5}</main>\n</body>\n</html>\n",
        tagOf(options.language), word("Lessons"), style, word("Contents"), contents, sections);
    const ByteView bytes = viewBytes(page);
    files.push_back({"index.html", Bytes(bytes.begin(), bytes.end())});
    return files;
}

} // namespace texplorer::screenshot
