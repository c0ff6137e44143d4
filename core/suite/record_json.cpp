#include "texplorer/suite/record_json.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/report/report_files.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/json_reader.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace texplorer::suite {
namespace {

constexpr std::size_t maxRecordText = std::size_t{1} << 20; ///< of a sentence, an explanation
constexpr std::size_t maxRecordCases = 1'000'000;
constexpr double maxSeconds = 1e9;
constexpr auto maxPixelCount = static_cast<std::size_t>( // of pixels
    std::min(std::uint64_t{1} << 48, std::uint64_t{std::numeric_limits<std::size_t>::max()}));

void writeText(OrderedJson& json, const char* key, const std::string& text) {
    if (!text.empty())
        json[key] = text;
}

OrderedJson pixelJson(const std::array<std::uint8_t, 4>& pixel) {
    OrderedJson json = OrderedJson::array();
    for (const std::uint8_t each : pixel)
        json.push_back(int{each});
    return json;
}

/// Without it, its numbers are 0 and left out.
bool wasCompared(const CaseRecord& record) {
    return !record.metric.empty() || record.score != 0 || record.tolerance != 0 || record.share != 0 ||
           record.shareOver != 0 || record.pixels != 0 || record.over != 0 || record.unexplained;
}

OrderedJson caseJson(const CaseRecord& record) {
    OrderedJson json{{"name", record.name}, {"state", rowOf(record.state).name}};
    writeText(json, "sentence", record.sentence);
    if (record.id)
        json["id"] = *record.id;
    writeText(json, "code", record.code);
    writeText(json, "explanation", record.explanation);
    json["seconds"] = record.seconds;
    json["attempt"] = record.attempt;
    if (record.signal != 0)
        json["signal"] = record.signal;
    writeText(json, "renderer", record.renderer);
    writeText(json, "driver", record.driver);
    writeText(json, "settings", record.settings);
    json["width"] = record.width;
    json["height"] = record.height;
    json["time"] = record.time;
    if (wasCompared(record)) {
        writeText(json, "metric", record.metric);
        json["score"] = record.score;
        json["tolerance"] = record.tolerance;
        json["share"] = record.share;
        json["shareOver"] = record.shareOver;
        json["pixels"] = record.pixels;
        json["over"] = record.over;
        if (record.unexplained)
            json["unexplained"] = *record.unexplained;
    }
    if (record.worst)
        json["worst"] = {{"x", record.worst->x},
                         {"y", record.worst->y},
                         {"expected", pixelJson(record.worst->expected)},
                         {"actual", pixelJson(record.worst->actual)}};
    writeText(json, "golden", record.golden);
    writeText(json, "expectedPicture", record.expectedPicture);
    writeText(json, "actualPicture", record.actualPicture);
    writeText(json, "differencePicture", record.differencePicture);
    writeText(json, "fingerprint", record.fingerprint);
    return json;
}

OrderedJson runJson(const RunRecord& run) {
    OrderedJson json{{"run", recordFormatVersion}};
    writeText(json, "program", run.program);
    writeText(json, "command", run.command);
    writeText(json, "started", run.started);
    json["suites"] = run.suites;
    writeText(json, "driver", run.driver);
    writeText(json, "version", run.version);
    writeText(json, "plan", run.plan);
    json["planned"] = run.planned;
    json["shard"] = {run.shard.number, run.shard.count};
    if (run.endedEarly)
        json["endedEarly"] = true;
    json["seconds"] = run.seconds;
    return json;
}

void readNumbers(JsonObject& object, const char* key, std::span<int> target, int min, int max) {
    const Json* json = object.find(key);
    if (!json)
        return;
    const auto isRight = [&](const Json& each) {
        return each.is_number_unsigned() && each >= min && each <= max;
    };
    if (!json->is_array() || json->size() != target.size() || !std::ranges::all_of(*json, isRight))
        return object.expect(key, fmt::format("{} whole numbers from {} to {}", target.size(), min, max));
    for (std::size_t i = 0; i < target.size(); ++i)
        target[i] = (*json)[i].get<int>();
}

void readPixel(JsonObject& object, const char* key, std::array<std::uint8_t, 4>& pixel) {
    std::array<int, 4> numbers{};
    readNumbers(object, key, numbers, 0, 255);
    std::ranges::transform(numbers, pixel.begin(), [](int each) { return static_cast<std::uint8_t>(each); });
}

void readWorst(const Json& json, const std::string& where, Problem& problem, WorstPixel& worst) {
    constexpr int max = 1 << 24;
    JsonObject object(json, where, problem);
    object.whole("x", worst.x, 0, max);
    object.whole("y", worst.y, 0, max);
    readPixel(object, "expected", worst.expected);
    readPixel(object, "actual", worst.actual);
}

void readState(JsonObject& object, State& state) {
    const Json* json = object.need("state");
    if (!json)
        return;
    const std::string name = json->is_string() ? json->get<std::string>() : std::string();
    const auto found = std::ranges::find(stateRows, std::string_view(name), &StateRow::name);
    if (found == stateRows.end())
        return object.expect("state", "the state of a case");
    state = found->state;
}

/// A file of the report's folder: a page and a merge follow it.
void readPicture(JsonObject& object, const char* key, std::string& name) {
    object.text(key, name, maxRecordText);
    if (!name.empty() && !report::staysInside(name))
        object.expect(key, "a file's name within the folder");
}

void readCase(const Json& json, const std::string& where, Problem& problem, CaseRecord& record) {
    constexpr int max = 1 << 24;
    JsonObject object(json, where, problem);
    object.need("name");
    object.text("name", record.name, maxRecordText);
    readState(object, record.state);
    std::string sentence;
    object.text("sentence", sentence, maxRecordText);
    record.sentence = std::move(sentence);
    if (object.find("id"))
        object.whole("id", record.id.emplace(), 1, max);
    object.text("code", record.code, maxRecordText);
    object.text("explanation", record.explanation, maxRecordText);
    object.number("seconds", record.seconds, 0, maxSeconds);
    object.whole("attempt", record.attempt, 1, max);
    object.whole("signal", record.signal, 0, 255);
    object.text("renderer", record.renderer, maxRecordText);
    object.text("driver", record.driver, maxRecordText);
    object.text("settings", record.settings, maxRecordText);
    std::array<int, 2> size{}; // as earlier versions wrote them
    readNumbers(object, "size", size, 0, max);
    record.width = size[0];
    record.height = size[1];
    object.whole("width", record.width, 0, max);
    object.whole("height", record.height, 0, max);
    object.number("time", record.time, 0, maxSeconds);
    object.text("metric", record.metric, maxRecordText);
    object.number("score", record.score, -maxSeconds, maxSeconds);
    object.number("tolerance", record.tolerance, 0, maxSeconds);
    object.number("share", record.share, 0, 1);
    object.number("shareOver", record.shareOver, 0, 1);
    object.whole("pixels", record.pixels, 0, maxPixelCount);
    object.whole("over", record.over, 0, maxPixelCount);
    if (object.find("unexplained"))
        object.whole("unexplained", record.unexplained.emplace(), 0, maxPixelCount);
    if (const Json* worst = object.find("worst"))
        readWorst(*worst, object.placeOf("worst"), problem, record.worst.emplace());
    object.text("golden", record.golden, maxRecordText);
    readPicture(object, "expectedPicture", record.expectedPicture);
    readPicture(object, "actualPicture", record.actualPicture);
    readPicture(object, "differencePicture", record.differencePicture);
    object.text("fingerprint", record.fingerprint, maxRecordText);
}

void readTexts(JsonObject& object, const char* key, std::vector<std::string>& texts) {
    object.list(key, 0, maxRecordCases, [&](const Json& each, const std::string& where) {
        if (each.is_string())
            texts.push_back(each.get<std::string>());
        else if (!object.problem())
            object.problem() =
                Error{ErrorCode::Malformed, Sentence("expected a text, found {0}", foundText(each)),
                      atPointer(where)};
    });
}

/// What a final report and the first line of a journal have.
void readHead(JsonObject& object, RunRecord& run) {
    readVersion(object, "run", recordFormatVersion);
    object.text("program", run.program, maxRecordText);
    object.text("command", run.command, maxRecordText);
    object.text("started", run.started, maxRecordText);
    readTexts(object, "suites", run.suites);
    object.text("driver", run.driver, maxRecordText);
    object.text("version", run.version, maxRecordText);
    std::string settings; // which older records have for the run and not for each case
    object.text("settings", settings, maxRecordText);
    object.text("plan", run.plan, maxRecordText);
    object.whole("planned", run.planned, 0, maxRecordCases);
    std::array<int, 2> shard{run.shard.number, run.shard.count};
    readNumbers(object, "shard", shard, 1, static_cast<int>(maxRecordCases));
    run.shard = {shard[0], shard[1]};
    object.flag("endedEarly", run.endedEarly);
    object.number("seconds", run.seconds, 0, maxSeconds);
    readTexts(object, "names", run.names);
}

/// Every case in the place of its name; one that no name says is refused.
class Cases {
public:
    explicit Cases(RunRecord& run)
        : run_(run) {
        for (std::size_t i = 0; i < run.names.size(); ++i)
            places_.emplace(run.names[i], i);
        records_.resize(run.names.size());
    }

    [[nodiscard]] Problem put(CaseRecord record) {
        const auto place = places_.find(record.name);
        if (place == places_.end())
            return Error{
                ErrorCode::Malformed, Sentence("{0} is not a case of this run", foundText(record.name)), {}};
        records_[place->second] = std::move(record);
        return {};
    }

    void finish() {
        for (std::optional<CaseRecord>& each : records_) {
            if (each)
                run_.cases.push_back(*std::move(each));
        }
    }

private:
    RunRecord& run_;
    std::unordered_map<std::string, std::size_t> places_;
    std::vector<std::optional<CaseRecord>> records_;
};

Result<RunRecord> parseHead(std::string_view line) {
    const Result<Json> json = parseStrictJson(line, maxRecordBytes);
    if (!json)
        return fail(json.error().code, json.error().message); // it is the line that is said
    RunRecord run;
    Problem problem;
    {
        JsonObject object(*json, "", problem);
        readHead(object, run);
    }
    return problem ? Result<RunRecord>(fail(*problem)) : run;
}

Result<RunRecord> parseReport(const Json& json) {
    RunRecord run;
    Problem problem;
    {
        JsonObject object(json, "", problem);
        readHead(object, run);
        object.find("counts"); // follow from the cases; written for readers of the beginning
        object.find("status");
        Cases cases(run);
        object.list("cases", 0, maxRecordCases, [&](const Json& each, const std::string& where) {
            CaseRecord record;
            readCase(each, where, problem, record);
            if (problem)
                return;
            if (const Problem unknown = cases.put(std::move(record)))
                problem = Error{unknown->code, unknown->message, atPointer(where)};
        });
        cases.finish();
    }
    return problem ? Result<RunRecord>(fail(*problem)) : run;
}

} // namespace

std::string asJson(const RunRecord& run) {
    OrderedJson json = runJson(run);
    OrderedJson counts = OrderedJson::object();
    for (const StateRow& row : stateRows)
        counts[std::string(row.name)] = run.count(row.state);
    counts["not-run"] = run.missing().size();
    json["counts"] = std::move(counts);
    json["status"] = exitStatus(run);
    json["names"] = run.names;
    OrderedJson cases = OrderedJson::array();
    for (const CaseRecord& each : run.cases)
        cases.push_back(caseJson(each));
    json["cases"] = std::move(cases);
    return dumpJson(json, 2) + "\n";
}

std::string journalStart(const RunRecord& run) {
    OrderedJson json = runJson(run);
    json["names"] = run.names;
    return dumpJson(json) + "\n";
}

std::string journalLine(const CaseRecord& record) {
    return dumpJson(caseJson(record)) + "\n";
}

Result<CaseRecord> parseCaseRecord(std::string_view text) {
    const Result<Json> json = parseStrictJson(text, maxRecordBytes);
    if (!json)
        return fail(json.error().code, json.error().message);
    CaseRecord record;
    Problem problem;
    readCase(*json, "", problem, record);
    return problem ? Result<CaseRecord>(fail(*problem)) : record;
}

Result<Journal> parseJournal(std::string_view text) {
    if (text.size() > maxRecordBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} bytes, found {1}", maxRecordBytes, text.size()));
    Journal journal;
    std::optional<Cases> cases;
    for (std::size_t line = 1; journal.wholeBytes < text.size(); ++line) {
        const std::size_t end = text.find('\n', journal.wholeBytes);
        if (end == std::string_view::npos) {
            journal.note = fmt::format("its last line, {}, is incomplete and ignored", line);
            break;
        }
        const std::string_view content = text.substr(journal.wholeBytes, end - journal.wholeBytes);
        const auto inLine = [&](const Error& error) { return fail(within(atLine(line), error)); };
        if (!cases) {
            Result<RunRecord> head = parseHead(content);
            if (!head)
                return inLine(head.error());
            journal.run = *std::move(head);
            cases.emplace(journal.run);
        } else {
            Result<CaseRecord> record = parseCaseRecord(content);
            if (!record)
                return inLine(record.error());
            if (const Problem unknown = cases->put(*std::move(record)))
                return inLine(*unknown);
        }
        journal.wholeBytes = end + 1;
    }
    if (!cases)
        return fail(ErrorCode::Malformed, "expected the journal of a run, found no complete line");
    cases->finish();
    return journal;
}

Result<RunRecord> parseRun(std::string_view text) {
    // A journal's first line is a whole object; a report's is not.
    const std::string_view first = text.substr(0, text.find('\n'));
    if (first.size() < text.size() && first.starts_with('{') && first.ends_with('}'))
        return parseJournal(text).map([](Journal journal) { return std::move(journal.run); });
    const Result<Json> json = parseStrictJson(text, maxRecordBytes);
    if (!json)
        return fail(json.error());
    if (!json->is_object() || !json->contains("texshot"))
        return parseReport(*json);
    // What "texshot test --json" prints has the record among its results.
    const Json results = json->value("results", Json());
    const Json command = json->value("command", Json());
    if (command != "test" || !results.is_array() || results.size() != 1 || !results.front().contains("run"))
        return fail(ErrorCode::Malformed,
                    Sentence("expected the run of texshot test, found a document of texshot {0} without it",
                             ProperName{command.is_string() ? shortened(command.get<std::string>()) : ""}));
    Result<RunRecord> run = parseReport(results.front());
    return run ? run : fail(within(atPointer("/results/0"), run.error()));
}

namespace {

/// Not shortened: what differs may be at its end.
std::string quotedWhole(const std::string& text) {
    return text.empty() ? "none" : fmt::format("\"{}\"", printable(text));
}

/// Empty: all are.
std::string firstNotIn(const std::vector<std::string>& names, const std::vector<std::string>& others) {
    const std::unordered_set<std::string_view> there(others.begin(), others.end());
    const auto found =
        std::ranges::find_if(names, [&](const std::string& name) { return !there.contains(name); });
    return found == names.end() ? std::string() : *found;
}

} // namespace

Result<void> checkResumable(const RunRecord& journal, const RunRecord& now) {
    struct Fact {
        std::string_view what;
        std::string then;
        std::string now;
    };
    const auto shardText = [](const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.count); };
    const std::array facts{
        Fact{"program", journal.program, now.program},
        Fact{"driver", journal.driver, now.driver},
        Fact{"driver's version", journal.version, now.version},
        Fact{"part", shardText(journal.shard), shardText(now.shard)},
    };
    for (const Fact& fact : facts) {
        if (fact.then != fact.now)
            return fail(ErrorCode::OutOfRange,
                        Sentence("the journal has another {0}, {1}; it is {2} now", fact.what,
                                 quotedWhole(fact.then), quotedWhole(fact.now)));
    }
    const std::string gone = firstNotIn(journal.names, now.names);
    const std::string added = firstNotIn(now.names, journal.names);
    if (!gone.empty() || !added.empty())
        return fail(ErrorCode::OutOfRange,
                    gone.empty()
                        ? Sentence("the journal has other cases: {0} is a new one", quotedWhole(added))
                        : Sentence("the journal has other cases: {0} is gone", quotedWhole(gone)));
    if (journal.plan != now.plan || journal.names != now.names)
        return fail(ErrorCode::OutOfRange, "the journal has the same cases in another order or division");
    return {};
}

} // namespace texplorer::suite
