#include "app/stage/spoken.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_place.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <variant>

namespace texplorer::stage {
namespace {

using lesson::Match;
using lesson::Predict;
using lesson::Try;

std::string languageTag() {
    const ui::Catalogue* catalogue = ui::catalogueInUse();
    std::string name(ui::rowOf(catalogue ? catalogue->language() : ui::Language::English).name);
    std::ranges::replace(name, '_', '-');
    return name;
}

std::string statusOf(const ui::Session& session, std::span<const Sentence> problems) {
    if (const Sentence& notice = session.look.notice.text; !notice.empty())
        return ui::tr(notice);
    const std::vector<Finding>& findings = session.document.findings;
    if (!findings.empty() && findings.front().severity <= Severity::Warning &&
        (problems.empty() || findings.front().reportedByRenderer))
        return ui::tr(ui::shownSentence(findings.front().sentence));
    return problems.empty() ? std::string() : ui::tr(problems.front());
}

std::string rowOf(const ui::Session& session) {
    const std::string& path = session.window.hoveredParam;
    const std::optional<ui::ParamPlace> place = ui::placeOf(session.document.scene, path);
    const Result<std::string> value = getParam(session.document.scene, path);
    if (!place || !value)
        return {};
    return fmt::format("{}: {}", ui::tr(ui::shownName(session.settings, *place->row)), *value);
}

struct TaskOf {
    const ui::LessonRun& run;
    SpokenStep& spoken;

    void operator()(const std::monostate& /*none*/) const {}
    void operator()(const Try& task) const { spoken.task = run.stepText(task.task); }
    void operator()(const Predict& task) const {
        spoken.task = run.stepText(task.question);
        std::ranges::transform(task.answers, std::back_inserter(spoken.answers),
                               [this](const lesson::Answer& each) { return run.stepText(each.text); });
        spoken.chosen = run.answer;
        if (run.answer)
            spoken.verdict = *run.answer == task.right
                                 ? run.reason()
                                 : ui::tr("Not this one. Look again, or try it in the window.");
    }
    void operator()(const Match& task) const {
        spoken.task = run.stepText(task.task);
        if (run.grade)
            spoken.verdict =
                run.grade->passed
                    ? ui::tr("Solved: your picture matches.")
                    : ui::tr(Sentence("{0} % of the pixels still differ.", ui::percentWrong(*run.grade)));
    }
};

SpokenStep stepOf(const ui::LessonRun& run) {
    const lesson::Step& step = run.lesson.steps[run.step];
    SpokenStep spoken{.lesson = run.text(run.lesson.title),
                      .step = run.step,
                      .steps = run.lesson.steps.size(),
                      .title = run.text(step.title),
                      .text = run.stepText(step.text)};
    std::visit(TaskOf{run, spoken}, step.task);
    return spoken;
}

} // namespace

Spoken spokenBy(const ui::Session& session, std::span<const Sentence> problems) {
    return {languageTag(), statusOf(session, problems), rowOf(session),
            session.lesson ? std::optional(stepOf(*session.lesson)) : std::nullopt};
}

} // namespace texplorer::stage
