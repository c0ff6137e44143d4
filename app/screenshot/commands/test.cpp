#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/criterion_argument.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/runs/run_files.h"
#include "app/screenshot/runs/run_folder.h"
#include "app/screenshot/runs/run_plan.h"
#include "app/view/pretence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/accept_list.h"
#include "texplorer/suite/junit.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/suite/rule_choice.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <new>
#include <optional>
#include <thread>

namespace texplorer::screenshot {
namespace {

constexpr int maxProcesses = 1024;
constexpr std::size_t maxDurationsBytes = std::size_t{64} << 20;

struct TestOptions {
    std::vector<std::string> suites; ///< with --pictures the two folders, where they have no names
    bool pictures = false;
    std::string expected;
    std::string actual;
    bool update = false;
    std::string accepted;
    std::vector<std::string> only;
    std::vector<std::string> renderers;
    std::string shaders;
    std::vector<std::string> pretended;
    int processes = 0; ///< 0: as many as there are processors
    std::string shard;
    std::string durations;
    std::string report;
    std::string junit;
    std::string json;
    std::string resume;
    int timeout = 0; ///< seconds; 0: as the suites say
    bool failFast = false;
    bool list = false;
    CriterionArgument criterion;
    ContextArgument context;
    std::vector<const Option*> ofSuites;  ///< what is for suites alone
    std::vector<const Option*> ofRunning; ///< what --list leaves without effect
};

/// 2 is an error, as of diff(1): 1 says that pictures differ.
ExitCode complainOfRun(const Error& error) {
    return complain(error, wrongCall);
}

Result<RunSetup> setupFor(const TestOptions& options, unsigned processes) {
    RunSetup setup{.only = options.only,
                   .report = options.resume.empty() ? options.report : options.resume,
                   .shaders = options.shaders,
                   .pretended = options.pretended,
                   .context = options.context.text};
    setup.threads = std::max(1U, std::thread::hardware_concurrency() / processes);
    for (const std::string& name : options.renderers) {
        const Result<RendererKind> renderer = parseChoice<RendererKind>(name, "--renderer");
        if (!renderer)
            return fail(renderer.error());
        if (std::ranges::find(setup.renderers, *renderer) == setup.renderers.end())
            setup.renderers.push_back(*renderer);
    }
    if (!options.pictures) {
        setup.suites = options.suites;
        return setup;
    }
    const Result<Criterion> criterion = parseCriterion(options.criterion);
    if (!criterion)
        return fail(criterion.error());
    setup.golden = options.expected.empty() ? options.suites[0] : options.expected;
    setup.actual = options.actual.empty() ? options.suites[1] : options.actual;
    setup.mask = options.criterion.mask;
    setup.criterion = *criterion;
    return setup;
}

Result<RunChoice> choiceFor(const TestOptions& options) {
    RunChoice choice{.update = options.update, .seconds = static_cast<double>(options.timeout)};
    if (!options.shard.empty()) {
        const Result<suite::Shard> shard = suite::parseShard(options.shard);
        if (!shard)
            return fail(shard.error().code, shard.error().message, atOption("--shard"));
        choice.shard = *shard;
    }
    if (!options.durations.empty()) {
        const Result<std::string> text = readText(options.durations, maxDurationsBytes);
        if (!text && text.error().code != ErrorCode::NotFound) // before the first run there is none
            return fail(text.error());
        const Result<suite::Durations> durations =
            text ? suite::parseDurations(*text) : Result<suite::Durations>(suite::Durations{});
        if (!durations)
            return fail(within(inFile(options.durations), durations.error()));
        choice.durations = *durations;
    }
    if (!options.accepted.empty()) {
        const Result<Bytes> list = readInput(options.accepted, suite::maxAcceptBytes);
        if (!list)
            return fail(list.error());
        choice.accepted = std::string(reinterpret_cast<const char*>(list->data()), list->size());
        choice.acceptedFrom = inputName(options.accepted);
    }
    return choice;
}

/// What makes the same run again.
std::string commandOf(const TestOptions& options) {
    std::string command = options.pictures ? "texshot test --pictures" : "texshot test";
    for (const std::string& each : options.suites)
        command += " " + shellWord(each);
    const auto add = [&command](const char* option, const std::string& value) {
        if (!value.empty())
            command += fmt::format(" {} {}", option, shellWord(value));
    };
    add("--expected", options.expected);
    add("--actual", options.actual);
    for (const std::string& each : options.only)
        add("--only", each);
    for (const std::string& each : options.renderers)
        add("--renderer", each);
    for (const std::string& each : options.pretended)
        add("--pretend", each);
    add("--shaders", options.shaders);
    if (options.context.text != ContextArgument().text)
        add("--context", options.context.text);
    if (options.pictures)
        add("--metric", options.criterion.metric);
    add("--tolerance", options.criterion.tolerance);
    add("--share", options.criterion.share);
    add("--mask", options.criterion.mask);
    if (options.criterion.rgb)
        command += " --rgb";
    if (options.criterion.givenPixelsPerDegree->isGiven())
        add("--pixels-per-degree", std::to_string(options.criterion.pixelsPerDegree));
    return command;
}

/// The same of this part of it.
std::string partOf(const TestOptions& options, std::string command) {
    for (const auto& [option, value] :
         {std::pair("--shard", &options.shard), std::pair("--durations", &options.durations)}) {
        if (!value->empty())
            command += fmt::format(" {} {}", option, shellWord(*value));
    }
    return command;
}

/// What one does now.
std::string nextSteps(const TestOptions& options, const FinishedRun& finished) {
    std::string text;
    const std::size_t without = finished.run.count(suite::State::New);
    if (without > 0 && !options.update)
        text += without == 1 ? "1 has no golden: --update writes it\n"
                             : fmt::format("{} have no golden: --update writes them\n", without);
    const std::string& report = options.resume.empty() ? options.report : options.resume;
    if (!report.empty())
        text += fmt::format("report: {}\n", (std::filesystem::path(report) / "index.html").string());
    return text;
}

ExitCode say(const TestOptions& options, const FinishedRun& finished, ExitCode status) {
    const bool toStandardOutput = options.json != "-" && options.junit != "-";
    std::string text;
    if (finished.resumed > 0)
        text += fmt::format("{} of {} cases were done before\n", finished.resumed, finished.run.names.size());
    text += suite::asText(finished.run);
    if (!finished.wrote.empty())
        text +=
            fmt::format("{} written\n", Sentence::plural("{0} golden", "{0} goldens", finished.wrote.size()));
    text += nextSteps(options, finished);
    if (loudness().quiet && status == success)
        return status;
    if (!toStandardOutput) {
        std::fputs(printable(text, LineBreaks::Keep).c_str(), stderr);
        return status;
    }
    const Result<void> printed = print(text);
    return printed ? status : complainOfRun(printed.error());
}

struct ResultFiles {
    std::optional<Output> json;
    std::optional<Output> junit;
    std::optional<Output> durations;
};

Result<ResultFiles> openResults(const TestOptions& options) {
    ResultFiles files;
    for (const auto& [path, file] :
         {std::pair(&options.json, &files.json), std::pair(&options.junit, &files.junit),
          std::pair(&options.durations, &files.durations)}) {
        if (path->empty() || (path == &options.durations && !options.shard.empty()))
            continue; // all shards must be dealt by the same durations
        Result<Output> output = Output::open(*path);
        if (!output)
            return fail(output.error());
        *file = *std::move(output);
    }
    return files;
}

Result<void> writeResults(const FinishedRun& finished, const ResultFiles& files,
                          const suite::Durations& before) {
    const auto& [json, junit, durations] = files;
    if (json) {
        const std::string text = documentText(
            nlohmann::ordered_json::array({nlohmann::ordered_json::parse(suite::asJson(finished.run))}));
        if (const Result<void> written = json->write(viewBytes(text)); !written)
            return written;
    }
    if (junit) {
        const std::string text = suite::asJunit(finished.run);
        if (const Result<void> written = junit->write(viewBytes(text)); !written)
            return written;
    }
    if (!durations)
        return {};
    const std::string text = suite::writeDurations(suite::durationsOf(finished.run, before));
    return durations->write(viewBytes(text));
}

/// The files that the call names, and those of its report.
std::vector<NamedOutput> outputsOfTest(const TestOptions& options) {
    std::vector<NamedOutput> outputs{{"--json", options.json}, {"--junit", options.junit}};
    if (options.shard.empty()) // else it is read alone
        outputs.push_back({"--durations", options.durations});
    const bool resumes = options.report.empty();
    if (const std::string& report = resumes ? options.resume : options.report; !report.empty())
        for (NamedOutput& each : outputsOfRunFolder(resumes ? "--resume" : "--report", report))
            outputs.push_back(std::move(each));
    return outputs;
}

/// No output, and no golden, takes the place of what the run reads.
Result<void> checkRunApart(const TestOptions& options, const PlannedRun& planned) {
    const std::vector<NamedOutput> outputs = outputsOfTest(options);
    const bool writesGoldens = options.update || !options.accepted.empty();
    if (!writesGoldens &&
        std::ranges::all_of(outputs, [](const NamedOutput& each) { return each.path.empty(); }))
        return {};
    RunFiles files = filesOfRun(planned);
    files.read.push_back(options.accepted);
    if (!options.shard.empty())
        files.read.push_back(options.durations);
    if (writesGoldens) {
        const auto goldens = screenshot::outputsOf(options.update ? "--update" : "--accept", files.goldens);
        if (Result<void> apart = checkNotRead(goldens, files.read); !apart)
            return apart;
    }
    std::ranges::move(files.goldens, std::back_inserter(files.read));
    return checkOutputsApart(outputs, files.read);
}

nlohmann::ordered_json itemJson(const PlannedRun& planned, const RunItem& item) {
    nlohmann::ordered_json json{{"name", item.name}};
    if (planned.plan.cases.empty())
        return json; // two pictures
    const suite::Case& of = planned.plan.cases[item.number];
    json["suite"] = planned.plan.suiteOf(of).name;
    json["renderer"] = rowOf(of.renderer).name;
    json["width"] = of.size.width;
    json["height"] = of.size.height;
    json["time"] = of.time;
    return json;
}

ExitCode list(const TestOptions& options, const PlannedRun& planned) {
    std::string text;
    nlohmann::ordered_json listed = nlohmann::ordered_json::array();
    for (const RunItem& each : planned.items) {
        text += printable(each.name) + "\n";
        listed.push_back(itemJson(planned, each));
    }
    if (options.json.empty()) {
        const Result<void> printed = print(text);
        return printed ? success : complainOfRun(printed.error());
    }
    const RunFiles files = filesOfRun(planned);
    Result<void> written = checkOutputsApart(std::array{NamedOutput{"--json", options.json}}, files.read);
    if (written)
        written = Output::open(options.json).and_then([&](const Output& output) {
            return output.write(viewBytes(documentText(std::move(listed))));
        });
    return written ? success : complainOfRun(written.error());
}

/// The folders of --pictures: both by their names, or both without, in the order of "texshot compare".
Result<void> checkFolders(const TestOptions& options) {
    const bool named = !options.expected.empty() || !options.actual.empty();
    if (!options.pictures)
        return options.suites.empty()
                   ? fail(ErrorCode::OutOfRange, "SUITE is missing; see texshot test --help")
                   : Result<void>();
    if (named ? !options.suites.empty() || options.expected.empty() || options.actual.empty()
              : options.suites.size() != 2)
        return fail(ErrorCode::OutOfRange,
                    "expected two folders, the goldens and the pictures: EXPECTED ACTUAL, or --expected "
                    "DIR --actual DIR",
                    atOption("--pictures"));
    if (!named && (options.update || !options.accepted.empty()))
        return fail(
            ErrorCode::OutOfRange,
            "expected --expected DIR and --actual DIR when goldens are written, so that the folders can't "
            "be confused",
            atOption(options.update ? "--update" : "--accept"));
    return {};
}

ExitCode refuseOptions(const TestOptions& options) {
    if (const Result<void> folders = checkFolders(options); !folders)
        return complainOfRun(folders.error());
    if (std::ranges::any_of(options.suites, isStandardInput))
        return complainOfRun(
            {ErrorCode::OutOfRange,
             N_("expected a file or a folder, which several processes can read; found standard input"),
             atOption("SUITE")});
    for (const Option* each : options.ofSuites) {
        if (options.pictures && each->isGiven())
            noteUnused(each->name(), "--pictures draws nothing");
    }
    for (const Option* each : options.ofRunning) {
        if (options.list && each->isGiven())
            noteUnused(each->name(), "--list runs nothing");
    }
    if (const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended); !pretence)
        return complainOfRun(pretence.error());
    if (const Result<view::ContextChoice> context = parseContext(options.context); !context)
        return complainOfRun(context.error());
    if (!options.report.empty() && !options.resume.empty() && options.report != options.resume)
        return complainOfRun({ErrorCode::OutOfRange,
                              Sentence("expected the folder of --report, {0}, or --resume alone, found {1}",
                                       inQuotes(options.report), inQuotes(options.resume)),
                              atOption("--resume")});
    return success;
}

/// Whether a text is the document of an earlier call of this command, without results.
bool isErrorOfTest(const std::string& text) {
    const auto document = nlohmann::json::parse(text, nullptr, false);
    return document.is_object() && document.value("results", nlohmann::json()) == nlohmann::json::array() &&
           document.value("command", nlohmann::json()) == "test";
}

/// Where --json names a file, a call that fails says so there, too: in the place of a record or an error, of
/// nothing else.
void writeError(const TestOptions& options) {
    const std::string error = errorText();
    if (error.empty() || options.json.empty() || isStandardOutput(options.json))
        return;
    const Result<std::string> there = readText(options.json, suite::maxRecordBytes);
    const bool isOurs = there ? isErrorOfTest(*there) || suite::parseRun(*there).has_value()
                              : there.error().code == ErrorCode::NotFound;
    if (!isOurs)
        return;
    if (const Result<Output> output = Output::open(options.json))
        static_cast<void>(output->write(viewBytes(error)));
}

/// `tellsErrors`: what goes wrong may be written where --json says. A wrong call writes nothing.
ExitCode test(const TestOptions& options, bool& tellsErrors) {
    if (const ExitCode refused = refuseOptions(options); refused != success)
        return refused;
    tellsErrors = true;
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const unsigned processes = options.processes > 0 ? static_cast<unsigned>(options.processes) : cores;
    const Result<RunSetup> setup = setupFor(options, processes);
    if (!setup)
        return complainOfRun(setup.error());
    const Result<RunChoice> choice = choiceFor(options);
    if (!choice)
        return complainOfRun(choice.error());
    Result<PlannedRun> planned =
        options.pictures ? planPictures(*setup, *choice) : planSuites(*setup, *choice);
    if (!planned)
        return complainOfRun(planned.error());
    if (options.list)
        return list(options, *planned);
    planned->run.command = partOf(options, commandOf(options));
    if (const Result<void> apart = checkRunApart(options, *planned); !apart) {
        tellsErrors = false;
        return complainOfRun(apart.error());
    }
    const Result<ResultFiles> files = openResults(options);
    if (!files)
        return complainOfRun(files.error());

    std::stop_source stop;
    std::optional<AskedToStop> asked(stop);
    RunOptions run;
    run.processes = static_cast<unsigned>(std::clamp<std::size_t>(planned->items.size(), 1, processes));
    run.failFast = options.failFast;
    run.resume = !options.resume.empty();
    run.acceptCommand = commandOf(options) + " --accept accept.txt"; // whatever part its cases are in
    run.says = loudness().quiet     ? RunProgress::Says::Nothing
               : loudness().verbose ? RunProgress::Says::EveryCase
                                    : RunProgress::Says::OneLine;
    run.stop = stop.get_token();
    const Result<FinishedRun> finished = runAll(*planned, run);
    asked.reset();
    if (!finished && finished.error().code == ErrorCode::Cancelled)
        return complainInterrupted(finished.error().message);
    if (!finished)
        return complainOfRun(finished.error());
    tellsErrors = false;
    const ExitCode status = say(options, *finished, static_cast<ExitCode>(suite::exitStatus(finished->run)));
    const Result<void> written = writeResults(*finished, *files, choice->durations);
    return written ? status : complainOfRun(written.error());
}

void declarePictures(Command& command, TestOptions& options) {
    const Option& pictures = command.flag(
        "--pictures", options.pictures,
        "Don't draw: compare the PNGs of two folders, from any program, by name. A picture without a "
        "golden, a golden without a picture and a picture of another size are failures. The folders are in "
        "the order of \"texshot compare\", EXPECTED ACTUAL, or named by options, which --update and "
        "--accept require.");
    command.option("--expected", options.expected, "With --pictures: the folder of the goldens.",
                   {.value = "DIR", .needs = &pictures});
    command.option("--actual", options.actual, "With --pictures: the folder of the pictures.",
                   {.value = "DIR", .needs = &pictures});
    addCriterionArgument(command, options.criterion, &pictures);
}

void declareChoice(Command& command, TestOptions& options) {
    const Option& update =
        command.flag("--update", options.update,
                     "Write the goldens that are missing, different or not pictures. Others are unchanged, "
                     "and nothing is written outside the suite's folder.");
    command.option(
        "--accept", options.accepted,
        "Run only the cases of a list, with one name a line as the report's page writes it, and write "
        "their goldens.",
        {.value = "LIST", .excludes = &update});
    command.option("--only", options.only,
                   "Only matching cases: a name, with * for any characters. Can be repeated.",
                   {.value = "PATTERN", .oneEach = true});
    options.ofSuites.push_back(&command.option(
        "--renderer", options.renderers,
        fmt::format("Instead of the renderers of the suite, one of {}, or several, separated by commas. "
                    "Can be repeated.",
                    listNames(EnumTable<RendererKind>::rows)),
        {.value = "RENDERER", .oneEach = true, .offers = {choiceNames<RendererKind>, true}}));
    options.ofSuites.push_back(&command.option(
        "--shaders", options.shaders,
        "The folder of the shader renderer's files. Default: the files that the program was built with.",
        {.value = "DIR", .environment = "TEXPLORER_SHADERS"}));
    addContextArgument(command, options.context);
    options.ofSuites.push_back(options.context.option);
    options.ofSuites.push_back(
        &command.option("--pretend", options.pretended, view::pretenceHelp(),
                        {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}}));
    command.option("--shard", options.shard,
                   "Run a part of the cases, such as 1/4 for the first of four; \"texshot merge\" joins "
                   "the parts.",
                   {.value = "I/N"});
    command.option("--durations", options.durations,
                   "A file with the seconds of each case, to make parts of equal duration. It is read, and "
                   "written without --shard; \"texshot merge\" also writes it.",
                   {.value = "FILE"});
}

void declareRunning(Command& command, TestOptions& options) {
    const auto running = [&options](const Option& option) { options.ofRunning.push_back(&option); };
    running(command.number("-j,--jobs", options.processes, 1, maxProcesses,
                           "The number of processes. Default: the number of processors."));
    const Option& report = command.option(
        "--report", options.report,
        "A folder for the report: index.html, which can be opened as a file, with the pictures of every "
        "failure, and run.json. The actual picture of a case contains its scene, as those of \"texshot "
        "shot\". --resume continues from its journal, journal.jsonl.",
        {.value = "DIR"});
    running(report);
    running(command.option("--junit", options.junit, "The result as JUnit's XML; - for standard output.",
                           {.value = "FILE"}));
    command.option(
        "--json", options.json,
        "The result as JSON, or with --list the cases; - for standard output. For a compared case: \"pixels\", of these \"over\" the "
        "tolerance, of these \"unexplained\" by its rule, if any; \"share\" is the allowed share of pixels "
        "over, or unexplained with a rule.",
        {.value = "FILE"});
    const Option& resume = command.option(
        "--resume", options.resume,
        "Continue an interrupted or killed run with a report in this folder: cases in its journal aren't "
        "run again, unless a scene, an image or a golden has changed since.",
        {.value = "DIR"});
    running(resume);
    options.ofSuites.push_back(&resume);
    running(command.number("--timeout", options.timeout, 1, 86400,
                           "The time limit of a case in seconds. Default: that of the suite, or 60."));
    running(command.flag("--fail-fast", options.failFast, "End after the first failure."));
    command.flag("--list", options.list, "List the cases without running them.");
}

} // namespace

void addTest(CommandLine& line) {
    Command& command = line.command("test", "Draw the pictures of a suite and compare them with their "
                                            "goldens.");
    auto options = std::make_shared<TestOptions>();
    command.usage({"SUITE...", "--pictures EXPECTED ACTUAL"});
    command.option(
        "SUITE", options->suites,
        "A suite's file; a folder of suites, *.suite.json, or, if there is none, of scenes X.json, each "
        "compared with X.png next to it. A scene without a picture is new, 512x512.");
    declarePictures(command, *options);
    declareChoice(command, *options);
    declareRunning(command, *options);
    command.footer(
        "Worker processes draw the cases. A case that crashes the driver or hangs fails alone; a case "
        "whose process is killed from outside, for example when out of memory, is tried once more.\n"
        "For a failure, the report has the picture, the golden, their difference and the output of "
        "\"texshot probe\" for the worst pixel. A golden is one or several stored pictures, or "
        "\"reference\": the picture by the specification, which needs no stored picture. Its rule, from "
        "\"texshot conform --list\", defines how much of a single picture may differ: " +
        suite::ruleLimits() +
        ".\n"
        "Exit status: 0 all are alike, 1 some are not, or are new, crashed or hung, 2 invalid arguments, a "
        "suite that can't be read or cases that could not be tried, 130 Ctrl+C.");
    command.onCall([options]() -> int {
        bool tellsErrors = false;
        ExitCode status = success;
        try {
            status = test(*options, tellsErrors);
        } catch (const std::bad_alloc&) {
            status = complainOfRun({ErrorCode::TooLarge, N_("not enough memory for this"), {}});
        }
        if (tellsErrors)
            writeError(*options);
        return status;
    });
}

} // namespace texplorer::screenshot
