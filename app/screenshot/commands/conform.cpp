#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/gl/mesa_settings.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/messages.h"
#include "texplorer/conform/made_files.h"
#include "texplorer/conform/report.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <optional>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

struct ConformOptions {
    std::string renderer;
    std::string against;
    std::vector<std::string> features;
    std::string folder;
    std::string shaders;
    std::vector<std::string> pretended;
    ContextArgument context;
    unsigned seed = 1;
    int scenes = 0; // 0: as many as the features have
    bool json = false;
    bool list = false;
    const Option* shadersOption = nullptr;
    std::vector<const Option*> notListing; ///< what --list leaves without effect
};

/// One of OpenGL's renderers in a studio.
class StudioRenderer : public conform::Renderer {
public:
    StudioRenderer(Studio& studio, RendererKind kind)
        : studio_(studio)
        , kind_(kind) {}
    Result<Frame> draw(const Scene& scene) override {
        return studio_.draw(kind_, {scene, conform::madeImages(), 0, conform::extent, conform::extent});
    }

private:
    Studio& studio_;
    RendererKind kind_;
};

/// Mesa takes shortcuts where it chooses mip levels and filters, unless it is told not to before it is
/// loaded: without them, what remains are errors. What the user has set is left alone. Returns what it
/// was told.
std::string askMesaForPrecision() {
    ::setenv(mesaPrecisionVariable, mesaPrecision, 0);
    // A picture is one tile: threads would only wait for each other. The other processors draw the reference.
    ::setenv(mesaThreadsVariable, mesaNoThreads, 0);
    return fmt::format("{}={}", mesaPrecisionVariable, std::getenv(mesaPrecisionVariable));
}

/// What makes the same report again, wherever it is typed.
std::string commandOf(const ConformOptions& options, const view::Pretence& pretence,
                      const conform::Selection& selection, const std::string& settings) {
    const std::size_t equals = settings.find('=') + 1;
    std::string command =
        fmt::format("{}{} texshot conform --seed {} --scenes {}", settings.substr(0, equals),
                    shellWord(settings.substr(equals)), selection.seed, selection.scenes);
    for (const conform::Feature* feature : selection.features)
        command += " --feature " + std::string(feature->name);
    const auto add = [&command](const char* option, const std::string& value) {
        if (!value.empty())
            command += fmt::format(" {} {}", option, shellWord(value));
    };
    add("--renderer", options.renderer);
    add("--against", options.against);
    add("--shaders", options.shaders);
    add("--pretend", pretence.text());
    if (options.context.text != ContextArgument().text)
        add("--context", options.context.text);
    return command;
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    std::array<char, 32> text{};
    if (gmtime_r(&time, &parts) == nullptr ||
        std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts) == 0)
        return {};
    return text.data();
}

Result<RendererKind> rendererOf(const std::string& name, const char* option) {
    return name.empty() ? RendererKind::Fixed : parseChoice<RendererKind>(name, option);
}

Result<std::vector<conform::Pair>> pairsOf(const ConformOptions& options) {
    if (options.renderer.empty() && options.against.empty())
        return std::vector(conform::defaultPairs.begin(), conform::defaultPairs.end());
    const Result<RendererKind> subject = rendererOf(options.renderer, "--renderer");
    const Result<RendererKind> against = rendererOf(options.against, "--against");
    for (const Result<RendererKind>* each : {&subject, &against}) {
        if (!*each)
            return fail(each->error());
    }
    if (*subject == *against && (options.renderer.empty() || options.against.empty())) {
        const bool named = !options.against.empty();
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a renderer other than {0}, the default of {1}", rowOf(*subject).name,
                             named ? "--renderer" : "--against"),
                    atOption(named ? "--against" : "--renderer"));
    }
    if (*subject == *against)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected two different renderers, found \"{0}\" twice", rowOf(*subject).name));
    return std::vector{conform::Pair{*subject, *against}};
}

/// Those of the pairs that the driver can draw; it is said why the others can't be. The error: there are
/// none.
Result<std::vector<conform::Pair>> drawable(const std::vector<conform::Pair>& pairs,
                                            const view::OfferedRenderers& offered) {
    std::vector<conform::Pair> possible;
    std::vector<Sentence> reasons;
    for (const conform::Pair& pair : pairs) {
        const RendererKind missing = offered.has(pair.subject) ? pair.against : pair.subject;
        if (offered.has(missing))
            possible.push_back(pair);
        else
            reasons.push_back(offered.whyNot(missing));
    }
    if (possible.empty())
        return fail(ErrorCode::Unsupported, reasons.front());
    for (const Sentence& reason : reasons)
        warn({ErrorCode::Unsupported, Sentence("{0}: it is not compared", reason), {}});
    return possible;
}

Result<conform::Selection> selectionOf(const ConformOptions& options) {
    conform::Selection selection;
    selection.seed = options.seed;
    int scenes = 0;
    for (const std::string& name : options.features) {
        const conform::Feature* feature = conform::findFeature(name);
        if (!feature)
            return refuseChoice(namesIn(conform::features()), name, "--feature");
        if (std::ranges::find(selection.features, feature) != selection.features.end())
            continue; // named twice
        selection.features.push_back(feature);
        scenes += feature->scenes;
    }
    selection.scenes = options.scenes > 0           ? options.scenes
                       : selection.features.empty() ? conform::defaultScenes
                                                    : scenes;
    return selection;
}

/// What a report takes the place of must be a report's: the folder is new, has none of its files, or has one.
Result<void> checkReportFolder(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    std::error_code ignored;
    const auto taken = std::ranges::find_if(
        names, [&](const std::string& name) { return std::filesystem::exists(folder / name, ignored); });
    const Result<std::string> there = readText(folder / conform::reportName);
    if (taken == names.end() || (there && conform::isReport(*there)))
        return {};
    return fail(ErrorCode::Unwritable,
                Sentence("expected a new folder or one with a report of texshot conform, found \"{0}\" of "
                         "something else",
                         *taken),
                inFile(folder.string()));
}

Result<void> writeFolder(const std::filesystem::path& folder, const conform::Report& report) {
    const Result<std::vector<report::File>> files = conform::asFolder(report);
    if (!files)
        return fail(files.error());
    std::vector<std::string> names;
    for (const report::File& file : *files)
        names.push_back(file.name);
    if (Result<void> ours = checkReportFolder(folder, names); !ours)
        return ours;
    std::vector<FileContent> contents;
    for (const report::File& file : *files)
        contents.push_back({file.name, file.bytes});
    std::optional<Uninterrupted> placing;
    return writeFolderAtomically(folder, contents, [&placing] { placing.emplace(); });
}

ExitCode conformTo(const ConformOptions& options) {
    if (options.list) {
        for (const Option* option : options.notListing)
            if (option->isGiven())
                noteUnused(option->name(), "--list compares nothing");
        const std::string text = options.json
                                     ? documentText(Json::array({Json::parse(conform::listingJson())}))
                                     : conform::listing();
        const Result<void> written = print(text);
        return written ? success : complain(written.error());
    }
    const Result<std::vector<conform::Pair>> pairs = pairsOf(options);
    if (!pairs)
        return complain(pairs.error(), wrongCall);
    const bool shaders =
        std::ranges::any_of(*pairs, [](const conform::Pair& pair) { return pair.has(RendererKind::Shader); });
    if (options.shadersOption->isGiven() && !shaders)
        noteUnused("--shaders", "it needs the shader renderer, which is not compared");
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return complain(pretence.error(), wrongCall);
    const Result<view::ContextChoice> context = parseContext(options.context);
    if (!context)
        return complain(context.error(), wrongCall);
    const Result<conform::Selection> selection = selectionOf(options);
    if (!selection)
        return complain(selection.error(), wrongCall);
    if (!options.folder.empty()) {
        if (const Result<void> possible = checkFolderWritable(options.folder); !possible)
            return complain(possible.error());
        if (const Result<void> ours = checkReportFolder(options.folder, report::pageFileNames()); !ours)
            return complain(ours.error());
    }

    const std::string settings = askMesaForPrecision();
    const Result<std::unique_ptr<Studio>> studio = openStudio(options.shaders, *pretence, *context);
    if (!studio)
        return complain(studio.error());
    const Result<std::vector<conform::Pair>> possible = drawable(*pairs, (*studio)->renderers());
    if (!possible)
        return complain(possible.error());
    StudioRenderer fixed(**studio, RendererKind::Fixed);
    StudioRenderer shader(**studio, RendererKind::Shader);
    LongWork work("texshot: comparing");
    conform::SweepOptions sweep;
    sweep.selection = *selection;
    sweep.pairs = *possible;
    sweep.driver = (*studio)->driver();
    sweep.driver.settings = settings;
    sweep.progress = [&work](float done) { work.report(done); };
    sweep.stop = work.stopToken();
    Result<conform::Report> report = conform::sweep(sweep, {&fixed, &shader});
    work.finish();
    if (work.stopToken().stop_requested())
        return complainInterrupted();
    if (!report)
        return complain(report.error());
    report->origin = {"texshot " TEXPLORER_VERSION, commandOf(options, *pretence, *selection, settings),
                      now()};

    if (!options.folder.empty()) {
        if (const Result<void> written = writeFolder(options.folder, *report); !written)
            return complain(written.error());
    }
    const std::string text = options.json ? documentText(Json::array({Json::parse(conform::asJson(*report))}))
                                          : conform::asText(*report);
    if (const Result<void> written = print(text); !written)
        return complain(written.error());
    return report->agrees() ? success : failure;
}

} // namespace

void addConform(CommandLine& line) {
    Command& command = line.command("conform", "Compare the renderers on thousands of small scenes.");
    auto options = std::make_shared<ConformOptions>();
    const std::string renderers = "one of " + listNames(EnumTable<RendererKind>::rows);
    command.option(
        "--renderer", options->renderer,
        fmt::format(
            "The renderer to compare, {}. Default, if --against is also missing: shader against fixed, and "
            "reference against fixed.",
            renderers),
        {.value = "RENDERER", .offers = {choiceNames<RendererKind>}});
    command.option("--against", options->against, fmt::format("The renderer to compare with, {}.", renderers),
                   {.value = "RENDERER", .offers = {choiceNames<RendererKind>}});
    command.option("--feature", options->features,
                   "Only these features, separated by commas; --list shows "
                   "them.",
                   {.value = "FEATURE", .offers = {[] { return namesIn(conform::features()); }, true}});
    command.number("--scenes", options->scenes, 1, 100000,
                   fmt::format("The number of scenes, divided among the features. Default: {}.",
                               conform::defaultScenes));
    command.number("--seed", options->seed, 0, std::numeric_limits<unsigned>::max(),
                   "The seed of the random scenes. The same seed gives the same scenes.",
                   {.showsDefault = true});
    command.option("-o,--out,--report", options->folder,
                   "A folder for the report: index.html for a browser, report.json, and for each feature "
                   "its worst scene with both pictures and their difference.",
                   {.value = "DIR"});
    options->shadersOption = &command.option(
        "--shaders", options->shaders,
        "The folder of the shader renderer's files. Default: the files that the program was built with.",
        {.value = "DIR", .environment = "TEXPLORER_SHADERS"});
    addContextArgument(command, options->context);
    command.option("--pretend", options->pretended,
                   view::pretenceHelp() + " Scenes that can't be compared are skipped and counted.",
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    for (const Option& option : command.options())
        options->notListing.push_back(&option);
    command.flag("--json", options->json, "The report, or the list, as JSON, for programs.");
    command.flag("--list", options->list,
                 "List the features, their rules with reasons, and what is not compared.");
    command.footer(
        "A table on standard output: \"over\" are the pixels that differ by more than the rule's bound (in "
        "255ths), \"unexplained\" those of them that the precision granted to the driver does not explain. "
        "The limits apply to thousands of scenes. For fewer scenes they are higher by as much as chance "
        "makes once in 10,000 samples, and the result is \"too few scenes\" if more pixels differ in fewer "
        "than 19 scenes.\n"
        "Exit status: 0 none differ, 1 some do or nothing could be drawn, 2 invalid arguments, 130 Ctrl+C.");
    command.onCall([options] { return conformTo(*options); });
}

} // namespace texplorer::screenshot
