#include "app/screenshot/reports/lesson_step.h"

#include "app/screenshot/reports/step_programs.h"
#include "app/ui/state/figures.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/image/convert.h"
#include "texplorer/lesson/match.h"
#include "texplorer/lesson/numbers.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/false_colors.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::screenshot {
namespace {

using lesson::LessonScene;

class StepWriter {
public:
    StepWriter(const PageLesson& lesson, std::size_t index, LessonScene start, lesson::StepNumbers numbers,
               const std::stop_token& stop)
        : lesson_(lesson)
        , step_(lesson.lesson.steps[index])
        , index_(index)
        , place_(fmt::format("{}-{}", lesson.anchor, index + 1))
        , start_(std::move(start))
        , numbers_(std::move(numbers))
        , stop_(stop) {}

    Result<PageStep> write();

private:
    [[nodiscard]] const PageWords& words() const { return lesson_.words; }
    /// A text of the step with its numbers.
    [[nodiscard]] std::string textHtml(const std::string& english) const {
        return htmlOf(numbers_.start.in(words().text(english)));
    }
    [[nodiscard]] std::string& section() { return out_.section; }

    Result<void> writeTask(const std::monostate& /*task*/) { return {}; }
    Result<void> writeTask(const lesson::Try& task);
    Result<void> writeTask(const lesson::Predict& predict);
    Result<void> writeTask(const lesson::Match& match);
    void writeTaskText(const std::string& kind, const std::string& english);
    /// What one sees when one wants to; on paper it stands on the last pages.
    void writeHidden(const std::string& summary, const std::string& html);

    /// The picture becomes a file, and this is how it is shown.
    Result<std::string> image(const std::string& name, const Result<Image>& picture, const std::string& alt);
    [[nodiscard]] Result<Image> shownPicture() const;
    [[nodiscard]] Result<Image> pictureWith(const std::vector<Edit>& edits) const;

    const PageLesson& lesson_;
    const lesson::Step& step_;
    std::size_t index_;
    std::string place_; ///< "wrap-3"
    LessonScene start_;
    lesson::StepNumbers numbers_;
    std::stop_token stop_;
    PageStep out_;
};

Result<PageStep> StepWriter::write() {
    const std::string title = words().text(step_.title);
    const Result<std::string> shown =
        image(place_, shownPicture(),
              words().word(Sentence("The picture of step {0}: {1}", index_ + 1, ProperName{title})));
    if (!shown)
        return fail(shown.error());
    Result<StepPrograms> programs = stepPrograms(lesson_, index_, start_, place_);
    if (!programs)
        return fail(programs.error());
    const lesson::Look& look = step_.look;
    const std::string mark = look.probeX < 0
                                 ? std::string()
                                 : fmt::format("<i class=\"mark\" style=\"left:{}%;top:{}%\"></i>",
                                               look.probeX / 10.0, look.probeY / 10.0);
    section() += fmt::format("<section class=\"step\" id=\"{}\">\n<div class=\"told\">\n<h3>{}. {}</h3>\n"
                             "<figure class=\"shown\">{}{}</figure>\n<p>{}</p>\n",
                             place_, index_ + 1, htmlOf(title), *shown, mark, textHtml(step_.text));
    const auto* const figure = std::ranges::find(ui::figureRows, look.figure, &ui::FigureRow::name);
    if (figure != ui::figureRows.end())
        section() += fmt::format(
            "<p class=\"source\">{}</p>\n",
            words().wordHtml(Sentence("In the window this step opens the figure {0}.", figure->label)));
    if (!lesson_.window.empty())
        section() += fmt::format("<p class=\"source\"><a href=\"{}\">{}</a></p>\n",
                                 htmlOf(fmt::format("{}&step={}", lesson_.window, index_ + 1)),
                                 words().wordHtml("Open this step in the window"));
    for (const Sentence& note : imageNotes(start_))
        section() += fmt::format("<p class=\"source\">{}</p>\n", words().wordHtml(note));
    section() += programs->excerpt + "</div>\n<div class=\"asked\">\n";
    if (const Result<void> task =
            std::visit([this](const auto& each) { return writeTask(each); }, step_.task);
        !task)
        return fail(task.error());
    section() += programs->whole + "</div>\n</section>\n";
    std::ranges::move(programs->files, std::back_inserter(out_.files));
    return std::move(out_);
}

void StepWriter::writeTaskText(const std::string& kind, const std::string& english) {
    section() +=
        fmt::format("<p class=\"task\"><b>{}.</b> {}</p>\n", words().wordHtml(kind), textHtml(english));
}

void StepWriter::writeHidden(const std::string& summary, const std::string& html) {
    const std::string name = words().wordHtml(summary);
    section() += fmt::format("<details><summary>{}</summary><p>{}</p></details>\n", name, html);
    out_.answer = fmt::format("<p><b>{}. {}.</b> {}</p>\n", index_ + 1, name, html);
}

Result<void> StepWriter::writeTask(const lesson::Try& task) {
    writeTaskText(N_("Try"), task.task);
    return {};
}

Result<void> StepWriter::writeTask(const lesson::Predict& predict) {
    writeTaskText(N_("Predict"), predict.question);
    std::string list;
    bool isPictured = false;
    for (std::size_t i = 0; i < predict.answers.size(); ++i) {
        const lesson::Answer& answer = predict.answers[i];
        std::string picture;
        if (!answer.edits.empty()) {
            isPictured = true;
            Result<std::string> shown =
                image(fmt::format("{}-answer-{}", place_, i + 1), pictureWith(answer.edits),
                      words().word(Sentence("The picture of answer {0}", static_cast<char>('A' + i))));
            if (!shown)
                return fail(shown.error());
            picture = *std::move(shown);
        }
        list += fmt::format("<li>{}{}</li>\n", picture, textHtml(answer.text));
    }
    section() += fmt::format("<ol class=\"answers{}\">\n{}</ol>\n", isPictured ? " pictured" : "", list);
    writeHidden(N_("The right answer"),
                fmt::format("{}. {}", static_cast<char>('A' + predict.right),
                            htmlOf(numbers_.answered.in(words().text(predict.reason)))));
    return {};
}

Result<void> StepWriter::writeTask(const lesson::Match& match) {
    writeTaskText(N_("Match"), match.task);
    const Result<std::string> shown =
        image(place_ + "-reached", pictureWith(match.edits), words().word("The picture to reach"));
    if (!shown)
        return fail(shown.error());
    section() += fmt::format("<figure>{}</figure>\n", *shown);
    std::string edits = withEdits(start_, match.edits)
                            .map([this](const LessonScene& reached) {
                                return newCallsHtml(lesson_, index_, start_, reached);
                            })
                            .value_or(std::string());
    if (!edits.empty())
        edits += words().wordHtml("As parameters of the scene:") + " ";
    bool isFirst = true;
    for (const Edit& edit : match.edits)
        edits +=
            fmt::format("{}<code>{}</code>", std::exchange(isFirst, false) ? "" : ", ", htmlOf(textOf(edit)));
    writeHidden(N_("Solution"), edits);
    return {};
}

Result<Image> StepWriter::pictureWith(const std::vector<Edit>& edits) const {
    return withEdits(start_, edits).and_then([this](const LessonScene& scene) {
        return lesson::drawSmall(scene, stop_);
    });
}

/// As the step shows it: false colours where the window has them.
Result<Image> StepWriter::shownPicture() const {
    const auto [width, height] = lesson::pageSize;
    const reference::DrawRequest request{start_.scene, start_.images, 0, width, height};
    reference::DrawOptions drawing;
    drawing.threads = 1; // other steps are drawn beside it
    drawing.stop = stop_;
    const EnumRow* row = findRow(EnumTable<reference::Shown>::rows, step_.look.shown);
    const auto shown = row ? static_cast<reference::Shown>(row->value) : reference::Shown::Picture;
    if (shown == reference::Shown::Picture)
        return reference::drawReference(request, drawing).map([](Frame frame) {
            return withoutAlpha(std::move(frame.image)); // the page must not shine through it
        });
    return reference::levelMap(request, {}, drawing).map([shown](const reference::LevelMap& map) {
        return reference::falseColors(map, shown);
    });
}

Result<std::string> StepWriter::image(const std::string& name, const Result<Image>& picture,
                                      const std::string& alt) {
    if (!picture)
        return fail(picture.error());
    Result<Bytes> bytes = encodePng(*picture);
    if (!bytes)
        return fail(bytes.error());
    out_.files.push_back({name + ".png", *std::move(bytes)});
    return fmt::format("<img src=\"{}.png\" alt=\"{}\" width=\"{}\" height=\"{}\">", name, htmlOf(alt),
                       picture->width, picture->height);
}

} // namespace

Result<PageStep> pageStep(const PageLesson& lesson, std::size_t index, const std::stop_token& stop) {
    Result<LessonScene> start = startOf(lesson.folder, lesson.lesson, index);
    if (!start)
        return fail(within(inFile(lesson.folder.placeOf(lesson::lessonFileName)), start.error()));
    Result<lesson::StepNumbers> numbers =
        numbersOf(*start, lesson.lesson.steps[index], lesson::pageSize, stop);
    if (!numbers)
        return fail(numbers.error());
    return StepWriter(lesson, index, *std::move(start), *std::move(numbers), stop).write();
}

} // namespace texplorer::screenshot
