#include "texplorer/lesson/lesson.h"
#include "texplorer/lesson/strict_json.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>

namespace texplorer::lesson {
namespace {

using Json = nlohmann::json;

struct Members : JsonObject {
    using JsonObject::JsonObject;

    void text(const char* key, std::string& target, bool isNeeded) {
        JsonObject::text(key, target, maxLessonBytes);
        if (isNeeded && target.empty())
            expect(key, N_("a text that isn't empty"));
    }
};

std::string keyNameList() {
    std::string names;
    for (const std::string_view name : keyNames)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
    return names;
}

void readEdits(Members& members, std::vector<Edit>& edits, std::size_t min) {
    members.list("edits", min, maxEdits, [&](const Json& json, const std::string& where) {
        if (std::optional<Edit> edit = parseEdit(json.is_string() ? json.get<std::string>() : std::string()))
            edits.push_back(*std::move(edit));
        else if (!members.problem())
            members.problem() = Error{
                ErrorCode::Malformed,
                Sentence("expected PATH=VALUE or preset:NAME, found {0}", foundText(json)), atPointer(where)};
    });
}

void readLook(const Json& json, const std::string& where, std::optional<Error>& problem, Look& look) {
    Members members(json, where, problem);
    members.text("param", look.param, false);
    members.text("tab", look.tab, false);
    members.text("figure", look.figure, false);
    members.text("shown", look.shown, false);
    members.text("renderer", look.renderer, false);
    const Json* probe = members.find("probe");
    const auto isThousandth = [](const Json& each) {
        return each.is_number_integer() && each >= 0 && each < 1000;
    };
    if (!probe)
        return;
    if (!probe->is_array() || probe->size() != 2 || !std::ranges::all_of(*probe, isThousandth))
        return members.say(ErrorCode::Malformed, "probe",
                           Sentence("expected {0}, found {1}",
                                    N_("two whole numbers from 0 to 999, in thousandths from the top left"),
                                    ProperName{shortened(probe->dump())}));
    look.probeX = (*probe)[0].get<int>();
    look.probeY = (*probe)[1].get<int>();
}

void readPredict(const Json& json, const std::string& where, std::optional<Error>& problem,
                 Predict& predict) {
    Members members(json, where, problem);
    members.text("question", predict.question, true);
    members.list("answers", minAnswers, maxAnswers, [&](const Json& each, const std::string& place) {
        Members answer(each, place, problem);
        answer.text("text", predict.answers.emplace_back().text, true);
        readEdits(answer, predict.answers.back().edits, 0);
    });
    const Json* right = members.find("right");
    if (!right || !right->is_number_integer() || *right < 0 || *right >= predict.answers.size())
        members.expect("right", Sentence("the number of the right answer, from 0 to {0}",
                                         std::max<std::size_t>(predict.answers.size(), 1) - 1));
    else
        predict.right = right->get<std::size_t>();
    members.text("reason", predict.reason, true);
}

void readMatch(const Json& json, const std::string& where, std::optional<Error>& problem, Match& match) {
    Members members(json, where, problem);
    members.text("task", match.task, true);
    readEdits(members, match.edits, 1);
}

void readTask(Members& members, Step& step) {
    int tasks = 0;
    if (const Json* json = members.find("try")) {
        ++tasks;
        Try& task = step.task.emplace<Try>();
        if (json->is_string() && !json->get_ref<const std::string&>().empty())
            task.task = json->get<std::string>();
        else
            members.expect("try", N_("a text that isn't empty"));
    }
    if (const Json* json = members.find("predict")) {
        ++tasks;
        readPredict(*json, members.placeOf("predict"), members.problem(), step.task.emplace<Predict>());
    }
    if (const Json* json = members.find("match")) {
        ++tasks;
        readMatch(*json, members.placeOf("match"), members.problem(), step.task.emplace<Match>());
    }
    if (tasks > 1)
        members.say(ErrorCode::Malformed, "", N_("expected one of try, predict and match, found more"));
}

void readStep(const Json& json, const std::string& where, std::optional<Error>& problem, Step& step) {
    Members members(json, where, problem);
    members.text("title", step.title, true);
    members.text("text", step.text, true);
    members.text("scene", step.scene, false);
    readEdits(members, step.edits, 0);
    if (const Json* fallback = members.find("fallback")) {
        Members alternative(*fallback, where + "/fallback", problem);
        alternative.text("text", step.fallback.emplace().text, true);
        readEdits(alternative, step.fallback->edits, 1);
    }
    if (const Json* look = members.find("look"))
        readLook(*look, where + "/look", problem, step.look);
    readTask(members, step);
}

void readCycle(Members& members, Cycle& cycle) {
    members.list("cycle", 1, maxChoices, [&](const Json& each, const std::string& place) {
        Members choice(each, place, members.problem());
        choice.text("label", cycle.choices.emplace_back().label, true);
        readEdits(choice, cycle.choices.back().edits, 1);
    });
}

void readAddition(Members& members, Addition& addition) {
    constexpr std::string_view components = "xyzw";
    members.text("path", addition.path, true);
    std::string component = "x";
    members.text("component", component, false);
    const std::size_t at = components.find(component);
    if (component.size() != 1 || at == std::string_view::npos)
        members.expect("component", N_("one of x, y, z, w"));
    else
        addition.component = static_cast<int>(at);
    const Json* add = members.find("add");
    const double amount = add && add->is_number() ? add->get<double>() : 0;
    constexpr double max = std::numeric_limits<float>::max();
    addition.amount = std::abs(amount) <= max ? static_cast<float>(amount) : 0;
    if (addition.amount == 0)
        members.expect("add", N_("a number other than 0 between -3.4e38 and 3.4e38"));
}

void readKey(const Json& json, const std::string& where, std::optional<Error>& problem,
             std::vector<LessonKey>& keys) {
    Members members(json, where, problem);
    LessonKey key;
    members.text("key", key.key, true);
    if (!isKeyName(key.key))
        members.expect("key", Sentence("A to Z, 0 to 9 or one of {0}", ProperName{keyNameList()}));
    if (std::ranges::find(keys, key.key, &LessonKey::key) != keys.end())
        members.say(ErrorCode::Malformed, "key",
                    Sentence("expected each key once, found {0} again", ProperName{key.key}));
    members.text("label", key.label, true);
    const bool isCycle = members.has("cycle");
    if (isCycle == members.has("path"))
        members.say(ErrorCode::Malformed, "",
                    isCycle ? N_("expected either cycle, or path and add, found both")
                            : N_("expected either cycle, or path and add, found neither"));
    if (members.has("path"))
        readAddition(members, key.effect.emplace<Addition>());
    else
        readCycle(members, key.effect.emplace<Cycle>());
    keys.push_back(std::move(key));
}

} // namespace

Result<Lesson> parseLesson(std::string_view text) {
    const Result<Json> json = parseStrictJson(text, maxLessonBytes);
    if (!json)
        return fail(json.error());
    Lesson lesson;
    std::optional<Error> problem;
    {
        Members members(*json, "", problem);
        readVersion(members, "lesson", lessonFormatVersion);
        members.text("title", lesson.title, true);
        members.text("source", lesson.source, false);
        members.text("about", lesson.about, true);
        members.list("steps", 1, maxSteps, [&](const Json& each, const std::string& where) {
            readStep(each, where, problem, lesson.steps.emplace_back());
        });
        members.list("keys", 0, maxKeys, [&](const Json& each, const std::string& where) {
            readKey(each, where, problem, lesson.keys);
        });
        if (!lesson.steps.empty() && lesson.steps.front().scene.empty())
            problem = problem
                          ? problem
                          : Error{ErrorCode::Malformed, N_("expected the scene that the lesson begins with"),
                                  atPointer("/steps/0/scene")};
    }
    if (problem)
        return fail(*problem);
    return lesson;
}

std::vector<std::string> textsOf(const Step& step) {
    std::vector<std::string> texts{step.title, step.text};
    if (step.fallback)
        texts.push_back(step.fallback->text);
    if (const auto* task = std::get_if<Try>(&step.task))
        texts.push_back(task->task);
    if (const auto* match = std::get_if<Match>(&step.task))
        texts.push_back(match->task);
    if (const auto* predict = std::get_if<Predict>(&step.task)) {
        texts.push_back(predict->question);
        std::ranges::transform(predict->answers, std::back_inserter(texts), &Answer::text);
        texts.push_back(predict->reason);
    }
    return texts;
}

std::vector<std::string> textsOf(const Lesson& lesson) {
    std::vector<std::string> texts{lesson.title, lesson.about};
    if (!lesson.source.empty())
        texts.push_back(lesson.source);
    for (const Step& step : lesson.steps)
        std::ranges::copy(textsOf(step), std::back_inserter(texts));
    for (const LessonKey& key : lesson.keys) {
        texts.push_back(key.label);
        if (const auto* cycle = std::get_if<Cycle>(&key.effect))
            std::ranges::transform(cycle->choices, std::back_inserter(texts), &KeyChoice::label);
    }
    return texts;
}

std::string_view signOfKey(std::string_view name) {
    struct Sign {
        std::string_view name;
        std::string_view sign;
    };
    constexpr std::array signs{Sign{N_("Up"), "↑"}, Sign{N_("Down"), "↓"}, Sign{N_("Left"), "←"},
                               Sign{N_("Right"), "→"}};
    const auto* found = std::ranges::find(signs, name, &Sign::name);
    return found != signs.end() ? found->sign : name;
}

bool isKeyName(std::string_view name) {
    const bool isLetter =
        name.size() == 1 && ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9'));
    return isLetter || std::ranges::find(keyNames, name) != keyNames.end();
}

} // namespace texplorer::lesson
