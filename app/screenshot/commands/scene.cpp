// A scene as a file: every parameter written out, the fewest that say the same, or what leads to it from
// another.

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/output.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_diff.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <array>
#include <filesystem>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct SceneOptions {
    SceneArgument scene;
    std::string out = "-";
    std::string from; ///< another scene, of --diff; empty: it is not compared
    bool isShort = false;
    bool json = false;
    bool inPlace = false;
};

fs::path wholePath(const fs::path& path) {
    std::error_code ignored; // where the current folder was removed, a relative name stays one
    return (fs::current_path(ignored) / path).lexically_normal();
}

/// The same scene with its images named from another folder: below it, or else by their whole path.
void nameFilesFrom(Scene& scene, const ImageSource& images, const fs::path& folder) {
    const fs::path here = wholePath(images.directory()) / "";
    const fs::path there = wholePath(folder) / "";
    if (here == there)
        return;
    renameFiles(scene, [&](const std::string& file) {
        if (images.fileInMemory(file))
            return file;
        const fs::path whole = (here / file).lexically_normal();
        const fs::path relative = whole.lexically_relative(there);
        const bool below = !relative.empty() && *relative.begin() != "..";
        return (below ? relative : whole).generic_string();
    });
}

void warnOfLostFiles(const Scene& scene, const ImageSource& images) {
    for (const std::string& file : filesOf(scene))
        if (images.fileInMemory(file))
            warn({ErrorCode::NotFound,
                  N_("is an image of the lesson and not in a folder; the scene names it anyway"),
                  inFile(file)});
}

/// What leads from one scene to another: what --set can do, and what it can't.
struct Edits {
    std::vector<std::pair<std::string, std::string>> sets; ///< parameters and their values
    std::vector<SceneChange> lengths;
};

Result<Edits> editsBetween(const Scene& from, const Scene& to) {
    Edits edits;
    for (SceneChange& change : changesBetween(from, to)) {
        if (change.isLength) {
            edits.lengths.push_back(std::move(change));
            continue;
        }
        const Result<std::string> value = getParam(to, change.path);
        if (!value)
            return fail(value.error());
        edits.sets.emplace_back(change.path, *value);
    }
    return edits;
}

std::string editsJson(const Edits& edits) {
    Json list = Json::array();
    for (const auto& [path, value] : edits.sets)
        list.push_back({{"set", {{path, value}}}});
    for (const SceneChange& each : edits.lengths)
        list.push_back({{"path", each.path}, {"from", each.from.english()}, {"to", each.to.english()}});
    return documentText(std::move(list));
}

std::string editsText(const Edits& edits) {
    std::string text;
    for (const auto& [path, value] : edits.sets)
        text += fmt::format("--set {}\n", shellWord(path + "=" + value));
    return text;
}

/// As of diff(1): 1 where they differ, 2 where it can't be told.
int compareWith(const SceneOptions& options, const Scene& to) {
    const auto from = openScene({.file = options.from});
    if (!from)
        return complain(from.error().error, wrongCall);
    const Result<Edits> edits = editsBetween(from->scene, to);
    if (!edits)
        return complain(edits.error(), wrongCall);
    if (const Result<void> printed = print(options.json ? editsJson(*edits) : editsText(*edits)); !printed)
        return complain(printed.error(), wrongCall);
    for (const SceneChange& each : edits->lengths)
        warn({ErrorCode::Unsupported,
              Sentence("{0} -> {1}: no --set changes how many elements a list has", each.from, each.to),
              each.path});
    return edits->sets.empty() && edits->lengths.empty() ? success : failure;
}

ExitCode writeTo(const SceneOptions& options, OpenedScene opened) {
    const bool printed = isStandardOutput(options.out);
    if (codecForExtension(options.out) != nullptr)
        return complain(
            {ErrorCode::Unsupported,
             Sentence("a scene is JSON: expected a name that ends in .json, found \"{0}\"; \"texshot shot\" "
                      "draws a picture",
                      options.out),
             atOption("--out")},
            wrongCall);
    SceneArgument read = options.scene;
    if (options.inPlace)
        read.file.clear();
    if (const Result<void> apart =
            checkOutputsApart(std::array{NamedOutput{"--out", options.out}}, filesOf(read, opened));
        !apart)
        return complain(apart.error(), wrongCall);
    nameFilesFrom(opened.scene, opened.images, printed ? fs::path() : fs::path(options.out).parent_path());
    warnOfLostFiles(opened.scene, opened.images);
    const std::string text = options.isShort ? writeShortScene(opened.scene) : writeScene(opened.scene);
    Result<void> written;
    if (!printed)
        written =
            Output::open(options.out).and_then([&](const Output& out) { return out.write(viewBytes(text)); });
    else if (!options.json)
        written = print(text);
    if (written && options.json)
        written = print(documentText(
            Json::array({{{"file", printed ? Json() : Json(options.out)}, {"scene", Json::parse(text)}}})));
    return written ? success : complain(written.error());
}

/// With --in-place what is read is what is written.
Result<SceneOptions> placed(SceneOptions options) {
    if (options.inPlace && (options.scene.file.empty() || isStandardInput(options.scene.file)))
        return fail(ErrorCode::OutOfRange, "expected SCENE, a file to overwrite", atOption("--in-place"));
    if (options.inPlace)
        options.out = options.scene.file;
    return options;
}

int sceneCommand(const SceneOptions& given) {
    const Result<SceneOptions> there = placed(given);
    if (!there)
        return complain(there.error(), wrongCall);
    const SceneOptions& options = *there;
    const bool compares = !options.from.empty();
    if (const Result<void> once = checkStandardInputOnce(std::array{options.scene.file, options.from}); !once)
        return complain(once.error(), wrongCall);
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, compares ? wrongCall : opened.error().code);
    return compares ? compareWith(options, opened->scene) : writeTo(options, *std::move(opened));
}

} // namespace

void addScene(CommandLine& line) {
    Command& command = line.command("scene", "Write a scene, with changes, as a file with every parameter.");
    auto options = std::make_shared<SceneOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.flag("--short", options->isShort,
                 "Only parameters that differ from the initial values: the shortest file of the scene.");
    const Option& out =
        command.option("-o,--out", options->out,
                       "The scene file to write; - for standard output, the default. Images are named "
                       "relative to its folder, on standard output to the current one.",
                       {.value = "FILE"});
    command.flag("--in-place", options->inPlace,
                 "Overwrite SCENE with the changes. Without this option no output may overwrite an input.",
                 {.excludes = &out});
    command.option(
        "--diff", options->from,
        "Instead of the scene, write the changes from this one to it: a line --set PATH=VALUE for each "
        "parameter, quoted for a shell. Elements that only one of them has can't be expressed; a warning "
        "names their list.",
        {.value = "FROM", .excludes = &out});
    command.flag(
        "--json", options->json,
        "The scene within the document for programs, which is no scene file: file, null for standard output, and "
        "scene. With --diff: set of each edit, or path, from and to of lists of different lengths.");
    command.usage({"[SCENE]", "SCENE --in-place", "--diff FROM [SCENE]"});
    command.footer(
        "Exit status: 0 done, 1 the scene can't be read or written, 2 invalid arguments. With --diff: 0 "
        "they are the same, 1 they differ, 2 one of them can't be read, or invalid arguments.");
    command.onCall([options] { return sceneCommand(*options); });
}

} // namespace texplorer::screenshot
