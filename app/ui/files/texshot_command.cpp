#include "app/ui/files/texshot_command.h"

#include "app/ui/files/recording_file.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/state/sheet_choice.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

/// The values to set in `base`, and those to write even if they are equal.
std::vector<edit::Set> assignmentsTo(const Scene& base, const Scene& scene, std::string_view always) {
    std::map<std::string, Value> before;
    forEachParam(base, [&](const std::string& path, const ParamRow& /*row*/, const Value& value) {
        before.emplace(path, value);
    });
    std::vector<edit::Set> assignments;
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        const auto found = before.find(path);
        if (found == before.end() || found->second != value || (!always.empty() && path.starts_with(always)))
            assignments.push_back({path, formatValue(row, value)});
    });
    return assignments;
}

/// Finds an order in which they can be set one after the other: a unit cannot be enabled before it has a
/// texture. Returns false if there is none, or if they do not lead to the scene.
bool canBeMade(std::vector<edit::Set>& assignments, Scene base, const Scene& scene) {
    std::vector<edit::Set> ordered;
    while (!assignments.empty()) {
        const std::size_t before = assignments.size();
        std::erase_if(assignments, [&](const edit::Set& each) {
            const bool made = setParam(base, each.path, each.value).has_value();
            if (made)
                ordered.push_back(each);
            return made;
        });
        if (assignments.size() == before)
            return false;
    }
    assignments = std::move(ordered);
    return base == scene;
}

/// A command for the session's scene: "texshot shot earth.json --set …", with " --time …" unless it is 0.
Result<std::string> sceneCommand(std::string words, const Session& session, double time) {
    const Document& document = session.document;
    const bool hasFile = !document.file.empty();
    const Scene base = hasFile ? document.saved : defaultScene();
    // A camera that was fitted to the window is not in the file.
    const std::string view =
        document.fit.aspect > 0 ? std::string(keyOf<&Scene::view>()) + "." : std::string();
    std::vector<edit::Set> assignments = assignmentsTo(base, document.scene, view);
    if (!canBeMade(assignments, base, document.scene))
        return fail(
            ErrorCode::Unsupported,
            "models, textures or passes were added or removed, which --set can't express: save the scene "
            "first");
    if (hasFile)
        words += ' ' + shellWord(document.file.string());
    for (const edit::Set& each : assignments)
        words += " --set " + shellWord(each.path + '=' + each.value);
    if (time != 0)
        words += fmt::format(" --time {}", time);
    return words;
}

/// " --renderer reference", with its settings that are not the default.
std::string referenceWords(const ViewSettings& view) {
    std::string words = fmt::format(" --renderer {}", rowOf(RendererKind::Reference).name);
    if (view.anisotropy != reference::AnisotropyMethod::Probes)
        words += fmt::format(" --anisotropy {}", texplorer::rowOf(view.anisotropy).name);
    if (view.rho != reference::RhoMethod::Ideal)
        words += fmt::format(" --rho {}", texplorer::rowOf(view.rho).name);
    return words;
}

std::string withOutput(const std::string& command, view::Size picture, const std::string& file) {
    return fmt::format("{} --size {}x{} -o {}", command, picture.width, picture.height, shellWord(file));
}

} // namespace

Result<std::string> texshotCommand(const Session& session, view::Size picture) {
    return sceneCommand(N_("texshot shot"), session, session.look.playback.time)
        .map([&](std::string command) {
            if (session.view.renderer == RendererKind::Reference)
                command += referenceWords(session.view);
            else if (session.view.renderer != RendererKind::Fixed)
                command += fmt::format(" --renderer {}", rowOf(session.view.renderer).name);
            return withOutput(command, picture, fileNameOf(session.document, ".png"));
        });
}

Result<std::string> sweepCommand(const Session& session) {
    if (const Result<SheetOrder> order = sheetOrder(session); !order)
        return fail(order.error());
    return sceneCommand(N_("texshot sweep"), session, session.look.playback.time)
        .map([&](std::string command) {
            const SheetChoice& choice = session.sheet;
            for (const SheetAxis& axis : axesOf(session))
                command += " --axis " + shellWord(axis.path + '=' + axis.values);
            command += referenceWords(session.view);
            if (choice.labels != sheet::LabelKind::Names)
                command += fmt::format(" --labels {}", texplorer::rowOf(choice.labels).name);
            return withOutput(command, {choice.width, choice.height}, sheetFileName(session.document));
        });
}

Result<std::string> animateCommand(const Session& session) {
    const Result<Recording> recording = recordingOf(session);
    if (!recording)
        return fail(recording.error());
    return sceneCommand(N_("texshot animate"), session, recording->picture.time)
        .map([&](std::string command) {
            const RecordingChoice& choice = session.recording;
            command += fmt::format(" --fps {} --seconds {}", choice.perSecond, recordedSeconds(session)) +
                       referenceWords(session.view);
            return withOutput(command, {choice.width, choice.height}, recordingFileName(session));
        });
}

} // namespace texplorer::ui
