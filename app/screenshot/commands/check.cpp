#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "app/view/pretence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/initial_like.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace texplorer::screenshot {
namespace {

struct Options {
    SceneArgument scene;
    std::vector<std::string> pretended;
    bool json = false;
};

/// What has the value that OpenGL or Texplorer starts with was set by nobody: that it has no effect is no
/// news. A texture that isn't shown is news even so: its scene has less than one thinks.
bool isWorthSaying(const Finding& finding, const Scene& scene, const Scene& initial) {
    if (finding.severity <= Severity::Note || finding.rule == "texture-not-shown")
        return true;
    const auto isSetTo = [](const Scene& start, const std::string& path, const std::string& value) {
        const Result<std::string> its = getParam(start, path);
        return its && *its == value;
    };
    static const Scene start = defaultScene();
    bool chosen = false;
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        if (chosen || !isPartOf(path, finding.path))
            return;
        const std::string text = formatValue(row, value);
        chosen = !isSetTo(initial, path, text) && !isSetTo(start, path, text);
    });
    return chosen;
}

/// What has no effect as a whole says so once, not again for each of its parts.
std::vector<Finding> worthSaying(const std::vector<Finding>& findings, const Scene& scene) {
    const Scene initial = initialLike(scene);
    std::vector<Finding> kept;
    std::ranges::copy_if(findings, std::back_inserter(kept),
                         [&](const Finding& each) { return isWorthSaying(each, scene, initial); });
    std::vector<Finding> said;
    std::ranges::copy_if(kept, std::back_inserter(said), [&](const Finding& each) {
        return each.severity <= Severity::Note || std::ranges::none_of(kept, [&](const Finding& whole) {
                   return whole.severity >= Severity::Hint && whole.path.size() < each.path.size() &&
                          isPartOf(each.path, whole.path);
               });
    });
    return said;
}

/// What was odd about a file and was survived.
struct Note {
    std::string path; ///< the parameter that names it
    Sentence sentence;
};

std::vector<Note> notesOf(const OpenedScene& opened) {
    std::vector<Note> notes;
    for (const FileName& name : fileNamesOf(opened.scene)) {
        const auto image = name.used ? opened.images.contentOf(name.file) : nullptr;
        if (!image)
            continue;
        for (const std::vector<Sentence>& sentences : {image->notes, image->remarks})
            for (const Sentence& sentence : sentences)
                notes.push_back({name.path, Sentence(describedKey, ProperName{name.file}, sentence)});
    }
    return notes;
}

std::string findingsText(const std::vector<Finding>& findings, const std::vector<Note>& notes) {
    std::string text;
    for (const Finding& each : findings) {
        text += fmt::format("{}: {}: {}{}\n", rowOf(each.severity).name, each.path,
                            each.severity >= Severity::Hint ? "no effect: " : "", printable(each.sentence));
        for (const Fix& fix : each.fixes) {
            text += fmt::format("    {}:", fix.label.english());
            for (const edit::Set& set : fix.assignments)
                text += " --set " + shellWord(set.path + "=" + set.value);
            text += "\n";
        }
    }
    for (const Note& each : notes)
        text += fmt::format("note: {}: {}\n", each.path, printable(each.sentence));
    return text;
}

std::string asJson(const std::vector<Finding>& findings, const std::vector<Note>& notes) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& each : findings) {
        nlohmann::ordered_json entry{
            {"severity", rowOf(each.severity).name}, {"rule", each.rule}, {"path", each.path}};
        entry.update(messageJson(each.sentence));
        entry["fixes"] = nlohmann::ordered_json::array();
        for (const Fix& fix : each.fixes) {
            nlohmann::ordered_json set = nlohmann::ordered_json::object();
            for (const edit::Set& one : fix.assignments)
                set[one.path] = one.value;
            entry["fixes"].push_back(messageJson(fix.label));
            entry["fixes"].back()["set"] = std::move(set);
        }
        list.push_back(std::move(entry));
    }
    for (const Note& each : notes) {
        list.push_back({{"severity", rowOf(Severity::Note).name}, {"rule", "image"}, {"path", each.path}});
        list.back().update(messageJson(each.sentence));
        list.back()["fixes"] = nlohmann::ordered_json::array();
    }
    return documentText(std::move(list));
}

ExitCode check(const Options& options) {
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return complain(pretence.error(), wrongCall);
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    const Decoding decoding = looksAtTexels(opened->scene) ? Decoding::Pixels : Decoding::Outline;
    const std::vector<Error> reasons = opened->images.loadAll(opened->scene, decoding);
    opened->images.fillMeshes(opened->scene);
    std::vector<Finding> findings =
        worthSaying(diagnose(opened->scene, opened->images, pretence->facts()), opened->scene);
    for (const Error& reason : reasons) {
        for (Finding& each : findings) {
            if (reason.where.steps().front().text == each.path)
                each.sentence = describe({reason.code, reason.message, reason.where.inside()});
        }
    }
    const std::vector<Note> notes = notesOf(*opened);
    const std::string text = options.json ? asJson(findings, notes) : findingsText(findings, notes);
    if (const auto written = print(text); !written)
        return complain(written.error());
    const bool clean = std::ranges::none_of(
        findings, [](const Finding& each) { return each.severity <= Severity::Warning; });
    return clean ? success : failure;
}

} // namespace

void addCheck(CommandLine& line) {
    Command& command = line.command("check", "Find errors, undefined results and settings without effect "
                                             "in a scene.");
    auto options = std::make_shared<Options>();
    addSceneOrLessonArgument(command, options->scene);
    command.option("--pretend", options->pretended, view::pretenceHelp(),
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    command.flag("--json", options->json,
                 "As JSON, for programs: severity, rule, path, message and fixes of each finding.");
    command.footer(
        "A line for each finding on standard output, errors first, with its fixes below it; then a note "
        "for each recovered defect of an image file. Only the headers of images are read, unless a pass "
        "blends or tests alpha.\n"
        "Settings without effect are listed if they differ from the initial values of OpenGL and "
        "Texplorer.\n"
        "The driver is not used, only what --pretend takes away: \"texshot shot\" reports what it lacks.\n"
        "Exit status: 0 there is no error and no warning, 1 there is one or the scene can't be read, 2 "
        "invalid arguments.");
    command.onCall([options] { return check(*options); });
}

} // namespace texplorer::screenshot
