#include "texplorer/lesson/lesson.h"
#include "texplorer/scene/params/json_object.h"
#include "texplorer/scene/params/json_problem.h"
#include "texplorer/text/json_end.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>

namespace texplorer::lesson {
namespace {

using Json = nlohmann::json;

constexpr int maxDepth = 16;

/// Sentences of lessons tell what is expected alone.
struct Members : JsonObject {
    Members(const Json& json, std::string where, std::optional<Error>& problem)
        : JsonObject(json, std::move(where), problem, Tells::Expected) {}

    void text(const char* key, std::string& target, bool isNeeded) {
        JsonObject::text(key, target, maxLessonBytes);
        if (isNeeded && target.empty())
            refuse(key, "a text that isn't empty");
    }

    template<class Take>
    void list(const char* key, std::size_t min, std::size_t max, const Take& take) {
        const Json* value = find(key);
        const std::size_t count = value && value->is_array() ? value->size() : 0;
        if ((value && !value->is_array()) || count < min || count > max) {
            if (value || min > 0)
                refuse(key, fmt::format("a list of {} to {}", min, max));
            return;
        }
        for (std::size_t i = 0; i < count; ++i)
            take((*value)[i], fmt::format("{}/{}", placeOf(key), i));
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
            members.problem() = Error{ErrorCode::Malformed, "expected PATH=VALUE or preset:NAME", where};
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
        return members.refuse("probe", "two whole numbers from 0 to 999, in thousandths from the top left");
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
        members.refuse("right", fmt::format("the number of the right answer, from 0 to {}",
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
            members.refuse("try", "a text that isn't empty");
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
        members.say(ErrorCode::Malformed, "", "expected one of try, predict and match, found more");
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
        members.refuse("component", "one of x, y, z, w");
    else
        addition.component = static_cast<int>(at);
    const Json* add = members.find("add");
    const float amount = add && add->is_number() ? add->get<float>() : 0;
    if (amount == 0 || !std::isfinite(amount))
        members.refuse("add", "a number other than 0");
    addition.amount = amount;
}

void readKey(const Json& json, const std::string& where, std::optional<Error>& problem,
             std::vector<LessonKey>& keys) {
    Members members(json, where, problem);
    LessonKey key;
    members.text("key", key.key, true);
    if (!isKeyName(key.key))
        members.refuse("key", fmt::format("A to Z, 0 to 9 or one of {}", keyNameList()));
    if (std::ranges::find(keys, key.key, &LessonKey::key) != keys.end())
        members.say(ErrorCode::Malformed, "key",
                    fmt::format("expected each key once, found {} again", key.key));
    members.text("label", key.label, true);
    const bool isCycle = members.has("cycle");
    if (isCycle == members.has("path"))
        members.say(ErrorCode::Malformed, "", "expected either cycle, or path and add");
    if (members.has("path"))
        readAddition(members, key.effect.emplace<Addition>());
    else
        readCycle(members, key.effect.emplace<Cycle>());
    keys.push_back(std::move(key));
}

tl::unexpected<Error> tooDeep() {
    return fail(ErrorCode::TooLarge, fmt::format("expected at most {} levels of brackets", maxDepth));
}

Result<Json> parseJson(std::string_view text) {
    if (text.size() > maxLessonBytes)
        return fail(ErrorCode::TooLarge,
                    fmt::format("expected at most {} bytes, found {}", maxLessonBytes, text.size()));
    if (const Result<void> whole = checkNoNul(text); !whole)
        return fail(whole.error());
    bool isTooDeep = false;
    const auto shallow = [&isTooDeep](int depth, Json::parse_event_t, const Json&) {
        isTooDeep = isTooDeep || depth > maxDepth;
        return !isTooDeep;
    };
    try {
        Json json = Json::parse(text, shallow);
        if (isTooDeep)
            return tooDeep();
        return json;
    } catch (const Json::parse_error& error) {
        if (isTooDeep)
            return tooDeep();
        const std::string_view read = text.substr(0, std::min(text.size(), error.byte));
        const auto line = 1 + std::ranges::count(read, '\n');
        return fail(ErrorCode::Malformed, mistakeIn(error.id, error.what()), fmt::format("line {}", line));
    } catch (const Json::exception& error) {
        return fail(ErrorCode::Malformed, mistakeIn(error.id, error.what()));
    }
}

} // namespace

Result<Lesson> parseLesson(std::string_view text) {
    const Result<Json> json = parseJson(text);
    if (!json)
        return fail(json.error());
    Lesson lesson;
    std::optional<Error> problem;
    {
        Members members(*json, "", problem);
        const Json* version = members.find("lesson");
        if (!version || !version->is_number_integer() || *version < 1)
            members.refuse("lesson", fmt::format("the version of the format, {}", lessonFormatVersion));
        else if (*version > lessonFormatVersion)
            members.say(ErrorCode::Unsupported, "lesson",
                        fmt::format("expected version {}, found {}", lessonFormatVersion, version->dump()));
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
            members.say(ErrorCode::Malformed, "steps/0/scene",
                        "expected the scene that the lesson begins with");
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
    constexpr std::array signs{Sign{"Up", "↑"}, Sign{"Down", "↓"}, Sign{"Left", "←"}, Sign{"Right", "→"}};
    const auto* found = std::ranges::find(signs, name, &Sign::name);
    return found != signs.end() ? found->sign : name;
}

bool isKeyName(std::string_view name) {
    const bool isLetter =
        name.size() == 1 && ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9'));
    return isLetter || std::ranges::find(keyNames, name) != keyNames.end();
}

} // namespace texplorer::lesson
