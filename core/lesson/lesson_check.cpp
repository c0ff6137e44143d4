#include "texplorer/lesson/lesson_check.h"

#include "texplorer/lesson/lesson_keys.h"
#include "texplorer/lesson/lesson_place.h"
#include "texplorer/lesson/mark_check.h"
#include "texplorer/lesson/match.h"
#include "texplorer/lesson/numbers.h"
#include "texplorer/reference/false_colors.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/renderer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace texplorer::lesson {
namespace {

using Problems = std::vector<Error>;

/// With edits that change the scene, and name no file that the step hasn't loaded.
Result<LessonScene> checkedEdits(const LessonScene& start, const std::vector<Edit>& edits) {
    Result<LessonScene> scene = withEdits(start, edits);
    if (!scene)
        return scene;
    for (const std::string& file : filesOf(scene->scene)) {
        if (!scene->images.holds(file))
            return fail(ErrorCode::NotFound, "the step's own scene has no such image", inFile(file));
    }
    return scene;
}

/// A name of a table that the window would pass over.
template<class Rows, class NameOf>
void checkName(std::string_view name, const Rows& rows, const NameOf& nameOf, const std::string& where,
               Problems& problems) {
    std::string names;
    for (const auto& row : rows) {
        if (name == nameOf(row))
            return;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", nameOf(row));
    }
    problems.push_back(
        {ErrorCode::NotFound,
         Sentence("expected one of {0}, found {1}", ProperName{names}, ProperName{inQuotes(name)}),
         atPointer(where)});
}

void checkLook(const Look& look, const Scene& scene, const std::string& place, Problems& problems) {
    const auto rowName = [](const EnumRow& row) { return row.name; };
    if (!look.param.empty()) {
        if (const Result<std::string> value = getParam(scene, look.param); !value)
            problems.push_back(at(place + "/param", value.error()));
    }
    if (!look.tab.empty())
        checkName(look.tab, lookTabs, std::identity{}, place + "/tab", problems);
    if (!look.figure.empty())
        checkName(look.figure, lookFigures, std::identity{}, place + "/figure", problems);
    if (!look.shown.empty())
        checkName(look.shown, EnumTable<reference::Shown>::rows, rowName, place + "/shown", problems);
    for (std::size_t from = 0; from < look.renderer.size();) {
        const std::size_t end = std::min(look.renderer.find(',', from), look.renderer.size());
        checkName(look.renderer.substr(from, end - from), EnumTable<RendererKind>::rows, rowName,
                  place + "/renderer", problems);
        from = end + 1;
    }
}

void checkTask(const Predict& predict, const LessonScene& start, const std::string& place,
               Problems& problems) {
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < predict.answers.size(); ++i) {
        const std::vector<Edit>& edits = predict.answers[i].edits;
        if (edits.empty())
            continue;
        const std::string where = fmt::format("{}/predict/answers/{}", place, i);
        const Result<LessonScene> scene = checkedEdits(start, edits);
        if (!scene) {
            problems.push_back(at(where, scene.error()));
            continue;
        }
        Result<Image> picture = drawSmall(*scene);
        if (!picture)
            problems.push_back(at(where, picture.error()));
        else if (std::ranges::any_of(pictures, [&](const Image& other) { return areAlike(other, *picture); }))
            problems.push_back({ErrorCode::Malformed, N_("its picture looks like that of another answer"),
                                atPointer(where)});
        else
            pictures.push_back(*std::move(picture));
    }
}

/// The shapes of a picture to reach: next to the task, on a page, in a high window.
constexpr std::array shapes{PictureSize{smallWidth, smallHeight}, PictureSize{320, 240},
                            PictureSize{smallHeight, smallWidth}};

void checkTask(const Match& match, const LessonScene& start, const std::string& place, Problems& problems) {
    const std::string where = place + "/match";
    const Result<LessonScene> target = checkedEdits(start, match.edits);
    if (!target)
        return problems.push_back(at(where, target.error()));
    for (const PictureSize& shape : shapes) {
        const Result<Image> given = drawSmall(start, {}, shape);
        const Result<Image> wanted = drawSmall(*target, {}, shape);
        if (!given || !wanted)
            return problems.push_back(at(where, given ? wanted.error() : given.error()));
        if (areAlike(*given, *wanted))
            return problems.push_back({ErrorCode::Malformed,
                                       Sentence("its picture of {0} × {1} is that of the step's own scene",
                                                shape.width, shape.height),
                                       atPointer(where)});
    }
}

/// As a driver with one unit has it.
void checkFallback(const LessonFolder& folder, const Lesson& lesson, std::size_t step, const Scene& start,
                   Problems& problems) {
    const std::string where = placeOf(step) + "/fallback";
    if (!wordsIn(lesson.steps[step].fallback->text).empty())
        problems.push_back({ErrorCode::Malformed, N_("expected no word in braces: this text has no picture"),
                            atPointer(where + "/text")});
    if (unitsUsed(start) < 2)
        return problems.push_back({ErrorCode::Malformed,
                                   N_("the step's scene uses one texture unit, so it is not needed"),
                                   atPointer(where)});
    const Result<LessonScene> instead = startOf(folder, lesson, step, StepImages::Leave, 1);
    if (!instead)
        problems.push_back(instead.error());
    else if (unitsUsed(instead->scene) > 1)
        problems.push_back({ErrorCode::Malformed,
                            Sentence("expected a scene with one texture unit, found one with {0}",
                                     unitsUsed(instead->scene)),
                            atPointer(where)});
}

/// Each has to do something in one step at least.
void checkKeys(const std::vector<LessonKey>& keys, const std::vector<Scene>& starts, Problems& problems) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Result<void> last;
        const bool works = std::ranges::any_of(starts, [&](const Scene& scene) {
            last = checkKey(scene, keys[i]);
            return last.has_value();
        });
        if (!works && !last)
            problems.push_back(at(fmt::format("/keys/{}", i), last.error()));
    }
}

/// Whether a step itself keeps its scene from beginning, rather than a step whose scene it goes on with.
/// `before`: what keeps that of the step before, if this one goes on with it.
bool isOwnFault(const Error& fault, std::size_t step, const std::optional<Error>& before) {
    const std::string place = placeOf(step);
    if (!fault.where.text().starts_with(place))
        return false; // an earlier step's edits
    if (!before || fault.message != before->message)
        return true;
    return fault.where.text().substr(place.size()) != before->where.text().substr(placeOf(step - 1).size());
}

void checkTask(const Try&, const LessonScene&, const std::string&, Problems&) {}
void checkTask(const std::monostate&, const LessonScene&, const std::string&, Problems&) {}

} // namespace

Problems checkLesson(const LessonFolder& folder, const Lesson& lesson) {
    Problems problems;
    std::vector<Scene> starts;
    std::optional<Error> fault; // of the step before
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const Step& step = lesson.steps[i];
        const Result<LessonScene> start = startOf(folder, lesson, i);
        const std::optional<Error> before = step.scene.empty() ? fault : std::nullopt;
        fault = start ? std::optional<Error>() : start.error();
        if (fault) {
            if (isOwnFault(*fault, i, before))
                problems.push_back(*fault);
            continue;
        }
        const std::string place = placeOf(i);
        checkLook(step.look, start->scene, place + "/look", problems);
        std::visit([&](const auto& task) { checkTask(task, *start, place, problems); }, step.task);
        checkMark(*start, step, place, problems);
        if (step.fallback)
            checkFallback(folder, lesson, i, start->scene, problems);
        starts.push_back(start->scene);
    }
    checkKeys(lesson.keys, starts, problems);
    return problems;
}

} // namespace texplorer::lesson
