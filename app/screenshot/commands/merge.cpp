#include "texplorer/suite/merge.h"

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/runs/case_pictures.h"
#include "app/screenshot/runs/run_folder.h"
#include "texplorer/files/file_io.h"
#include "texplorer/suite/junit.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/suite/shard.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <new>
#include <optional>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

struct MergeOptions {
    std::vector<std::string> runs;
    std::string out;
    std::string report;
    std::string junit;
    std::string durations;
};

ExitCode complainOfMerge(const Error& error) {
    return complain(error, wrongCall);
}

/// The record of a run: of a report's folder what it has there.
std::string recordIn(const std::string& path) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored))
        return path;
    const fs::path record = fs::path(path) / recordName;
    return (fs::exists(record, ignored) ? record : fs::path(path) / journalName).string();
}

Result<std::vector<suite::RunRecord>> readRuns(const std::vector<std::string>& paths) {
    std::vector<suite::RunRecord> runs;
    for (const std::string& each : paths) {
        const std::string path = recordIn(each);
        const Result<Bytes> bytes = readInput(path, suite::maxRecordBytes);
        if (!bytes)
            return fail(bytes.error());
        Result<suite::RunRecord> run =
            suite::parseRun({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
        if (!run)
            return fail(within(inFile(inputName(path)), run.error()));
        runs.push_back(*std::move(run));
    }
    return runs;
}

/// The pictures of each case are in the report that its record came from: beside that run's file.
Result<void> gatherPictures(suite::RunRecord& merged, const std::vector<suite::RunRecord>& runs,
                            const std::vector<std::string>& paths, const fs::path& folder,
                            std::vector<std::string>& problems) {
    struct Place {
        const suite::CaseRecord* record;
        fs::path folder;
    };
    std::multimap<std::string_view, Place> places;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const suite::CaseRecord& each : runs[i].cases)
            places.emplace(each.name, Place{&each, fs::path(recordIn(paths[i])).parent_path()});
    }
    for (suite::CaseRecord& each : merged.cases) {
        const auto [first, last] = places.equal_range(each.name);
        const auto own =
            std::find_if(first, last, [&](const auto& place) { return *place.second.record == each; });
        if (own == last)
            continue;
        if (const Result<void> copied = copyPictures(own->second.folder, folder, each, problems); !copied)
            return copied;
    }
    return {};
}

/// What is read: the records, and the pictures beside them.
std::vector<std::string> filesOfMerge(const MergeOptions& options) {
    std::vector<std::string> files;
    for (const std::string& each : options.runs) {
        const std::string record = recordIn(each);
        files.push_back(record);
        if (!isStandardInput(record))
            std::ranges::move(filesIn((fs::path(record).parent_path() / picturesFolder).string()),
                              std::back_inserter(files));
    }
    return files;
}

std::vector<NamedOutput> outputsOfMerge(const MergeOptions& options) {
    std::vector<NamedOutput> outputs{
        {"--out", options.out}, {"--junit", options.junit}, {"--durations", options.durations}};
    if (!options.report.empty())
        for (NamedOutput& each : outputsOfRunFolder("--report", options.report))
            outputs.push_back(std::move(each));
    return outputs;
}

/// An old report's pictures go once the new one is whole.
Result<void> writeReport(const RunFolder& folder, suite::RunRecord run,
                         const std::vector<suite::RunRecord>& runs, const MergeOptions& options,
                         std::vector<std::string>& problems) {
    if (const Result<void> gathered = gatherPictures(run, runs, options.runs, options.report, problems);
        !gathered)
        return gathered;
    const Result<void> finished =
        folder.finish(run, run.command.empty() ? std::string() : run.command + " --accept accept.txt");
    if (finished)
        removePictures(options.report, run.cases);
    return finished;
}

Result<void> writeText(const std::string& path, const std::string& text) {
    const Result<Output> output = Output::open(path);
    return output ? output->write(viewBytes(text)) : fail(output.error());
}

Result<void> writeDurations(const suite::RunRecord& run, const std::string& path) {
    const Result<std::string> text = readText(path);
    if (!text && text.error().code != ErrorCode::NotFound)
        return fail(text.error());
    Result<suite::Durations> before =
        text ? suite::parseDurations(*text) : Result<suite::Durations>(suite::Durations{});
    if (!before)
        return fail(within(inFile(path), before.error()));
    const std::string now = suite::writeDurations(suite::durationsOf(run, *std::move(before)));
    return writeText(path, now);
}

int merge(const MergeOptions& options) {
    if (const Result<void> apart = checkOutputsApart(outputsOfMerge(options), filesOfMerge(options)); !apart)
        return complainOfMerge(apart.error());
    if (const Result<void> once = checkStandardInputOnce(options.runs); !once)
        return complainOfMerge(once.error());
    const Result<std::vector<suite::RunRecord>> runs = readRuns(options.runs);
    if (!runs)
        return complainOfMerge(runs.error());
    Result<suite::Merged> merged = suite::merge(*runs, options.runs);
    if (!merged)
        return complainOfMerge(merged.error());
    if (!options.report.empty()) { // first: nothing is written where it can't be
        const Result<RunFolder> folder = RunFolder::open(options.report);
        if (!folder)
            return complainOfMerge(folder.error());
        if (const Result<void> written = writeReport(*folder, merged->run, *runs, options, merged->problems);
            !written)
            return complainOfMerge(written.error());
    }
    if (const Result<void> written = writeText(options.out, suite::asJson(merged->run)); !written)
        return complainOfMerge(written.error());
    if (!options.junit.empty()) {
        if (const Result<void> written = writeText(options.junit, suite::asJunit(merged->run)); !written)
            return complainOfMerge(written.error());
    }
    if (!options.durations.empty()) {
        if (const Result<void> written = writeDurations(merged->run, options.durations); !written)
            return complainOfMerge(written.error());
    }
    for (const std::string& problem : merged->problems)
        complain({ErrorCode::Malformed, problem, {}});
    if (options.out != "-") {
        if (const Result<void> printed = print(suite::asText(merged->run)); !printed)
            return complainOfMerge(printed.error());
    }
    return merged->status;
}

} // namespace

void addMerge(CommandLine& line) {
    Command& command = line.command("merge", "Join the parts of a run of \"texshot test --shard\".");
    auto options = std::make_shared<MergeOptions>();
    command.option(
        "RUN", options->runs,
        "The report folder of each part, its run.json, or the output of --json; the journal of a killed "
        "run works, too. Only run.json has pictures next to it.",
        {.required = true});
    command.option("-o,--out", options->out, "The whole run as JSON; - for standard output.",
                   {.value = "FILE", .required = true});
    command.option("--report", options->report,
                   "A folder for the report of all parts, with the pictures next to each RUN.",
                   {.value = "DIR"});
    command.option("--junit", options->junit, "The whole run as JUnit's XML.", {.value = "FILE"});
    command.option("--durations", options->durations, "A file with the seconds of each case, to update.",
                   {.value = "FILE"});
    command.footer(
        "If several parts have a case, the later attempt is used, or the worse one of the same attempt.\n"
        "Exit status: 0 all cases of the whole run are alike, 1 some are not, 2 cases could not be tried "
        "or are missing, or a file can't be read, or invalid arguments.");
    command.onCall([options]() -> int {
        try {
            return merge(*options);
        } catch (const std::bad_alloc&) {
            return complainOfMerge({ErrorCode::TooLarge, N_("not enough memory for this"), {}});
        }
    });
}

} // namespace texplorer::screenshot
