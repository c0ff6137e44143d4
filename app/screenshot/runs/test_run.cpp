#include "app/screenshot/runs/test_run.h"

#include "app/screenshot/gl/mesa_settings.h"
#include "app/screenshot/output/message_ids.h"
#include "app/screenshot/runs/case_worker.h"
#include "app/screenshot/runs/run_folder.h"
#include "app/screenshot/workers/pool.h"
#include "texplorer/base/further.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/suite/judge_case.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <sys/wait.h>

namespace texplorer::screenshot {
namespace {

using suite::CaseRecord;
using suite::State;
using Outcome = workers::Outcome;

/// Of the pictures that are drawn at once, unless one alone has more: each takes some 30 bytes a pixel while
/// it is drawn, judged and encoded.
constexpr std::uint64_t maxPixelsAtOnce = std::uint64_t{64} << 20;

/// What the user hasn't set.
std::vector<std::string> environmentFor(bool precise, unsigned processes) {
    std::vector<std::string> environment;
    const auto add = [&environment](const char* name, const char* value) {
        if (std::getenv(name) == nullptr)
            environment.push_back(fmt::format("{}={}", name, value));
    };
    if (precise)
        add(mesaPrecisionVariable, mesaPrecision);
    if (processes > 1)
        add(mesaThreadsVariable, mesaNoThreads);
    return environment;
}

/// How precisely a driver draws there, as far as a variable says it.
std::string settingsFor(bool precise) {
    const char* users = std::getenv(mesaPrecisionVariable);
    const char* value = users != nullptr ? users : precise ? mesaPrecision : nullptr;
    return value == nullptr ? std::string() : fmt::format("{}={}", mesaPrecisionVariable, value);
}

State stateOf(Outcome::End end) {
    return end == Outcome::End::Hung ? State::TimedOut : State::Crashed;
}

class TestRun {
public:
    TestRun(const PlannedRun& planned, const RunOptions& options)
        : planned_(planned)
        , options_(options)
        , progress_(options.says, planned.items.size())
        , pool_({.command = {.arguments = {"texshot"}},
                 .processes = options.processes,
                 .maxWeight = maxPixelsAtOnce,
                 .stop = options.stop})
        , records_(planned.items.size())
        , started_(std::chrono::steady_clock::now()) {
        finished_.run = planned.run;
    }

    Result<FinishedRun> run();

private:
    [[nodiscard]] Result<void> openFolder();
    [[nodiscard]] Result<void> askForDriver();
    [[nodiscard]] Result<void> takeUp();
    [[nodiscard]] Result<void> work();
    [[nodiscard]] Result<void> workOn(const std::vector<std::size_t>& indices, bool update);
    [[nodiscard]] std::vector<std::size_t> order() const;
    [[nodiscard]] std::map<std::size_t, std::size_t> sharers() const;
    [[nodiscard]] workers::Job jobOf(std::size_t index, bool update) const;
    [[nodiscard]] CaseRecord recordOf(std::size_t index, const Outcome& outcome);
    [[nodiscard]] CaseRecord recordWithout(const RunItem& item, State state, const Sentence& sentence);
    [[nodiscard]] std::string fingerprintOf(const RunItem& item);
    [[nodiscard]] std::string_view workerOf(const RunItem& item) const;
    [[nodiscard]] bool drawsWithOpenGl(const RunItem& item) const;
    void keep(std::size_t index, CaseRecord record);
    void collect();
    [[nodiscard]] Error interrupted() const;

    const PlannedRun& planned_;
    const RunOptions& options_;
    RunProgress progress_;
    workers::Pool pool_;
    std::optional<RunFolder> folder_;
    suite::Fingerprints fingerprints_;
    std::vector<std::optional<CaseRecord>> records_; ///< of each item
    std::map<std::size_t, std::size_t> sharers_;     ///< see sharers
    std::optional<Error> broken_;                    ///< why no more is handed out
    bool failed_ = false;                            ///< a case isn't alike
    bool begun_ = false;                             ///< there is a journal
    FinishedRun finished_;
    std::chrono::steady_clock::time_point started_;
};

Result<void> TestRun::openFolder() {
    if (planned_.setup.report.empty())
        return {};
    std::error_code ignored;
    if (options_.resume && !std::filesystem::exists(planned_.setup.report + "/" + journalName, ignored))
        return fail(ErrorCode::NotFound, "there is no run to resume in this folder",
                    inFile(planned_.setup.report));
    Result<RunFolder> folder = RunFolder::open(planned_.setup.report);
    if (!folder)
        return fail(folder.error());
    folder_.emplace(*std::move(folder));
    return {};
}

/// Every process opens OpenGL, as it would for its first case. One answer will do: a process may have been
/// killed from outside, so a crash is believed when it comes again.
Result<void> TestRun::askForDriver() {
    if (!planned_.drawsWithOpenGl || planned_.items.empty())
        return {};
    const bool precise = planned_.items[order().front()].precise;
    const workers::Job job{.message =
                               bytesOf(WorkOrder{.setup = planned_.setup, .what = WorkOrder::What::Driver}),
                           .environment = environmentFor(precise, options_.processes),
                           .limit = std::chrono::duration<double>(
                               std::ranges::max_element(planned_.items, {}, &RunItem::limit)->limit),
                           .counts = false};
    std::optional<Error> problem;
    bool hung = false;
    bool answered = false;
    const auto take = [&](const Outcome& outcome) {
        const Result<WorkAnswer> answer = parseAnswer(outcome.answer);
        if (outcome.end != Outcome::End::Answered) { // there is nothing to be parsed then
            hung = hung || outcome.end == Outcome::End::Hung;
            problem = {ErrorCode::Driver,
                       Sentence("OpenGL can't be opened: {0}", sentenceOf(outcome, "the driver")),
                       {}};
        } else if (!answer || answer->problem) {
            problem = answer ? answer->problem : answer.error();
        } else {
            answered = true;
            finished_.run.driver = answer->driver;
            finished_.run.version = answer->version;
        }
    };
    constexpr int maxRounds = 3;
    for (int round = 0; round < maxRounds && !answered && !hung; ++round) {
        std::size_t left = round > 0 ? 1 : std::min<std::size_t>(options_.processes, planned_.items.size());
        const Result<void> asked = pool_.run(
            [&]() -> std::optional<workers::Job> {
                if (left == 0)
                    return std::nullopt;
                --left;
                return job;
            },
            take);
        if (!asked)
            return asked;
    }
    return answered ? Result<void>() : fail(*problem);
}

std::string TestRun::fingerprintOf(const RunItem& item) {
    if (planned_.plan.cases.empty())
        return {};
    const suite::Case& of = planned_.plan.cases[item.number];
    const bool drawn = drawsWithOpenGl(item);
    return fingerprints_.of(planned_.plan, of,
                            drawnWith(planned_.setup, drawn ? finished_.run.version : std::string()),
                            drawn ? finished_.run.driver : std::string());
}

/// What the folder's journal has, or a new one.
Result<void> TestRun::takeUp() {
    if (!folder_)
        return {};
    begun_ = true;
    if (!options_.resume)
        return folder_->begin(finished_.run);
    const Result<std::map<std::string, CaseRecord>> done = folder_->resume(finished_.run);
    if (!done)
        return fail(done.error());
    for (std::size_t i = 0; i < records_.size(); ++i) {
        const RunItem& item = planned_.items[i];
        const auto found = done->find(item.name);
        if (found == done->end() || item.update || found->second.fingerprint != fingerprintOf(item))
            continue; // the scene, its images or its golden are others now
        ++finished_.resumed;
        records_[i] = found->second;
        progress_.add(found->second);
    }
    return {};
}

/// Those that Mesa draws in the same way one after the other; of these, what takes longest first, or as they
/// stand: neighbours share images.
std::vector<std::size_t> TestRun::order() const {
    std::vector<std::size_t> sorted(planned_.items.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    std::ranges::stable_sort(sorted, [this](std::size_t a, std::size_t b) {
        const RunItem& x = planned_.items[a];
        const RunItem& y = planned_.items[b];
        return x.precise != y.precise ? y.precise : x.expected > y.expected;
    });
    return sorted;
}

/// The items whose golden an earlier one is to write, with that one: what is written once must do for both.
std::map<std::size_t, std::size_t> TestRun::sharers() const {
    std::map<std::size_t, std::size_t> sharing;
    std::map<std::filesystem::path, std::size_t> written;
    for (std::size_t i = 0; i < planned_.items.size() && !planned_.plan.cases.empty(); ++i) {
        const suite::Case& of = planned_.plan.cases[planned_.items[i].number];
        if (!planned_.items[i].update ||
            std::holds_alternative<suite::GoldenReference>(planned_.plan.settingsOf(of).golden))
            continue;
        const bool drawn = of.renderer != RendererKind::Reference;
        const std::vector<std::string> goldens =
            suite::goldensOf(planned_.plan, of, drawn ? finished_.run.driver : std::string());
        for (const std::string& golden : goldens) {
            const auto path = (planned_.plan.suiteOf(of).folder / golden).lexically_normal();
            if (const auto [owner, isNew] = written.emplace(path, i); !isNew)
                sharing.emplace(i, owner->second);
        }
    }
    return sharing;
}

workers::Job TestRun::jobOf(std::size_t index, bool update) const {
    const RunItem& item = planned_.items[index];
    const bool pictures = planned_.plan.cases.empty();
    WorkOrder what{.setup = planned_.setup,
                   .what = pictures ? WorkOrder::What::Pictures : WorkOrder::What::Case,
                   .number = item.number,
                   .name = pictures ? item.name : std::string(),
                   .hasActual = item.hasActual,
                   .hasGolden = item.hasGolden,
                   .update = item.update && update};
    return {.number = index,
            .message = bytesOf(what),
            .environment = environmentFor(item.precise, options_.processes),
            .limit = std::chrono::duration<double>(item.limit),
            .weight = item.pixels};
}

CaseRecord TestRun::recordWithout(const RunItem& item, State state, const Sentence& sentence) {
    CaseRecord record{.name = item.name, .state = state, .sentence = sentence};
    if (!planned_.plan.cases.empty()) {
        record = suite::recordOf(planned_.plan, planned_.plan.cases[item.number], state, sentence);
        if (drawsWithOpenGl(item))
            record.driver = finished_.run.driver;
    }
    record.fingerprint = fingerprintOf(item);
    return record;
}

CaseRecord TestRun::recordOf(std::size_t index, const Outcome& outcome) {
    const RunItem& item = planned_.items[index];
    CaseRecord record;
    if (outcome.end == Outcome::End::Answered) {
        Result<WorkAnswer> answer = parseAnswer(outcome.answer);
        if (answer && answer->record && answer->record->name == item.name) {
            record = *std::move(answer->record);
            if (!answer->wrote.empty())
                finished_.wrote.push_back(answer->wrote);
        } else {
            const Error other{ErrorCode::Malformed, N_("the worker process answered another question"), {}};
            record = suite::problemOf(recordWithout(item, State::Error, {}),
                                      answer ? answer->problem.value_or(other) : answer.error());
        }
    } else {
        record = recordWithout(item, stateOf(outcome.end), sentenceOf(outcome, workerOf(item)));
        if (outcome.end == Outcome::End::Crashed && WIFSIGNALED(outcome.status))
            record.signal = WTERMSIG(outcome.status);
        if (!outcome.lastWords.empty())
            record.explanation = "Last output:\n" + printable(outcome.lastWords, LineBreaks::Keep);
    }
    if (!record.id) // else the worker process said it
        record.id = firstIdOf(record.sentence);
    if (const auto sharer = sharers_.find(index); sharer != sharers_.end() && record.state == State::Failed)
        record.sentence = Sentence(furtherKey, record.sentence,
                                   Sentence("its golden is also that of {0}, from which --update writes it",
                                            ProperName{planned_.items[sharer->second].name}));
    if (drawsWithOpenGl(item))
        record.settings = settingsFor(item.precise);
    record.seconds = outcome.took.count();
    record.attempt = outcome.attempt;
    return record;
}

/// Who does the work of an item, for sentences.
std::string_view TestRun::workerOf(const RunItem& item) const {
    if (planned_.plan.cases.empty())
        return "the comparison";
    return drawsWithOpenGl(item) ? "the driver" : "the reference";
}

bool TestRun::drawsWithOpenGl(const RunItem& item) const {
    return !planned_.plan.cases.empty() &&
           planned_.plan.cases[item.number].renderer != RendererKind::Reference;
}

void TestRun::keep(std::size_t index, CaseRecord record) {
    progress_.add(record);
    failed_ = failed_ || suite::rowOf(record.state).status != 0;
    if (folder_ && !broken_) {
        if (const Result<void> added = folder_->add(record); !added)
            broken_ = added.error();
    }
    records_[index] = std::move(record);
}

Result<void> TestRun::workOn(const std::vector<std::size_t>& indices, bool update) {
    std::size_t next = 0;
    return pool_.run(
        [&]() -> std::optional<workers::Job> {
            while (next < indices.size() && records_[indices[next]])
                ++next;
            if (next == indices.size() || broken_ || (failed_ && options_.failFast))
                return std::nullopt;
            return jobOf(indices[next++], update);
        },
        [&](const Outcome& outcome) { keep(outcome.number, recordOf(outcome.number, outcome)); });
}

Result<void> TestRun::work() {
    std::vector<std::size_t> first = order();
    sharers_ = sharers();
    const auto later =
        std::ranges::stable_partition(first, [&](std::size_t index) { return !sharers_.contains(index); });
    const std::vector<std::size_t> last(later.begin(), later.end());
    first.erase(later.begin(), later.end());
    const Result<void> done = workOn(first, true);
    return done ? workOn(last, false) : done;
}

void TestRun::collect() {
    for (std::optional<CaseRecord>& each : records_) {
        if (each)
            finished_.run.cases.push_back(*std::move(each));
    }
    finished_.run.endedEarly = failed_ && options_.failFast;
    finished_.run.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

Error TestRun::interrupted() const {
    const auto done = std::ranges::count_if(records_, [](const auto& each) { return each.has_value(); });
    const Sentence far("{0} of {1} done", done, Sentence::plural("{0} case", "{0} cases", records_.size()));
    const bool resumable = begun_ && !planned_.plan.cases.empty();
    return {ErrorCode::Cancelled,
            resumable ? Sentence("{0}; the same call with --resume {1} continues", far,
                                 ProperName{shellWord(planned_.setup.report)})
                      : far,
            {}};
}

Result<FinishedRun> TestRun::run() {
    if (const Result<void> opened = openFolder(); !opened)
        return fail(opened.error());
    Result<void> done = askForDriver();
    if (done)
        done = takeUp();
    if (done)
        done = work();
    progress_.clear();
    if (!done)
        return fail(done.error().code == ErrorCode::Cancelled ? interrupted() : done.error());
    if (broken_)
        return fail(*broken_);
    collect();
    if (folder_) {
        if (const Result<void> written = folder_->finish(finished_.run, options_.acceptCommand); !written)
            return fail(written.error());
    }
    return std::move(finished_);
}

} // namespace

Result<FinishedRun> runAll(const PlannedRun& planned, const RunOptions& options) {
    return TestRun(planned, options).run();
}

} // namespace texplorer::screenshot
