#include "app/stage/messages.h"

#include "app/ui/files/address.h"
#include "app/ui/files/answers.h"
#include "app/ui/model/session.h"
#include "app/ui/state/lesson_records.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/storage/scene_link.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::stage {
namespace {

using Json = nlohmann::ordered_json;

std::string textOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Not an object where it is no JSON, or deeper than a scene.
Json parse(std::string_view text) {
    constexpr int maxDepth = 32; // each level takes stack when it is written again
    bool isDeep = false;
    Json json = Json::parse(
        text,
        [&](int depth, Json::parse_event_t /*event*/, const Json& /*parsed*/) {
            isDeep |= depth > maxDepth;
            return !isDeep;
        },
        false);
    return isDeep ? Json() : json;
}

/// A member that has to be a text.
Result<std::string> textIn(const Json& message, const char* name) {
    const auto found = message.find(name);
    if (found == message.end() || !found->is_string())
        return fail(ErrorCode::Malformed, N_("expected a text"), atName(name));
    return found->get<std::string>();
}

Result<Json> set(ui::Session& session, const Json& message) {
    const Result<std::string> path = textIn(message, "path");
    const Result<std::string> value = textIn(message, "value");
    if (!path || !value)
        return fail(path ? value.error() : path.error());
    const std::vector<Edit> edits{edit::Set{*path, *value}};
    Scene tried = session.document.scene;
    if (const Result<void> made = makeEdits(tried, edits); !made)
        return fail(made.error());
    static_cast<void>(makeEdits(session.document.saved, edits)); // only the user's edits are unsaved work
    ui::submit(session, {.name = N_("Edit by the page"), .edits = edits, .path = *path});
    return Json::object();
}

Result<Json> load(ui::Session& session, const Json& message) {
    const auto given = message.find("scene");
    if (given == message.end())
        return fail(ErrorCode::Malformed, N_("expected a scene or a link to one"), atName("scene"));
    Result<Scene> scene =
        given->is_string() ? parseSceneLink(given->get<std::string>()) : parseScene(textOf(*given));
    if (!scene)
        return fail(scene.error());
    session.document.saved = *scene;
    session.document.images.fillMeshes(session.document.saved);
    ui::submit(session, {.name = N_("Scene of the page"),
                         .edits = {edit::Replace{std::make_shared<const Scene>(*std::move(scene))}}});
    return Json::object();
}

Result<Json> open(ui::Session& session, const Json& message) {
    const Result<std::string> address = textIn(message, "address");
    if (!address)
        return fail(address.error());
    if (const Result<void> opened = ui::openAddress(session, *address); !opened)
        return fail(opened.error());
    return Json::object();
}

Result<Json> read(ui::Session& session, const Json& /*message*/) {
    const std::string answers = ui::answersText(session.settings);
    return Json{{"scene", Json::parse(writeScene(session.document.scene))},
                {"answers", Json::parse(answers).at("answers")}};
}

struct Action {
    std::string_view name;
    Result<Json> (*run)(ui::Session& session, const Json& message);
};
constexpr std::array actions{Action{"set", set}, Action{"load", load}, Action{"open", open},
                             Action{"read", read}};

Result<Json> run(ui::Session& session, const Json& message) {
    if (message.value("texplorer", Json()) != messageVersion)
        return fail(ErrorCode::Unsupported,
                    Sentence("expected {0}, the version of the messages", messageVersion),
                    atName("texplorer"));
    const Result<std::string> name = textIn(message, "do");
    if (!name)
        return fail(name.error());
    const auto* action = std::ranges::find(actions, *name, &Action::name);
    if (action == actions.end())
        return fail(ErrorCode::NotFound,
                    Sentence("expected set, load, open or read, found \"{0}\"", shortened(*name)),
                    atName("do"));
    return action->run(session, message);
}

} // namespace

std::string answerMessage(ui::Session& session, std::string_view text) {
    const Json message = parse(text);
    Json answer{{"texplorer", messageVersion}};
    if (!message.is_object()) {
        answer["error"] = "expected a JSON object of at most 32 levels";
        return textOf(answer);
    }
    if (const auto id = message.find("id"); id != message.end() && (id->is_string() || id->is_number()))
        answer["id"] = *id;
    const Result<Json> done = run(session, message);
    if (done)
        answer.update(*done);
    else
        answer["error"] = describe(done.error()).english();
    return textOf(answer);
}

std::string LessonEvents::take(const ui::Session& session) {
    if (!session.lesson) {
        last_.clear();
        return {};
    }
    const ui::LessonRun& run = *session.lesson;
    const ui::LessonProgress progress = progressOf(session.settings, run.key, run.lesson.steps.size());
    Json event{{"texplorer", messageVersion}, {"event", "lesson"},
               {"lesson", run.folder.name()}, {"step", run.step + 1},
               {"steps", progress.steps},     {"done", isStepDone(session.settings, run.key, run.step)},
               {"stepsDone", progress.done}};
    if (run.answer)
        event["answer"] = *run.answer + 1;
    std::string text = textOf(event);
    if (text == last_)
        return {};
    last_ = text;
    return text;
}

} // namespace texplorer::stage
