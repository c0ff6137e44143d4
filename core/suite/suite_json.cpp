#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/example.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/json_reader.h"
#include "texplorer/suite/rule_choice.h"
#include "texplorer/suite/suite.h"
#include "texplorer/suite/suite_folder.h"
#include "texplorer/text/json_encoding.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace texplorer::suite {
namespace {

constexpr std::string_view pictureExtension = ".png";
constexpr std::array<std::string_view, 3> placeholders{"case", "picture", "driver"};
/// What a rule of the reference takes the place of.
constexpr std::array boundKeys{"metric", "tolerance", "share", "rgb", "pixelsPerDegree"};

template<Enumerated E>
std::vector<std::string_view> namesOfRows() {
    std::vector<std::string_view> names;
    for (const EnumRow& each : EnumTable<E>::rows)
        names.push_back(each.name);
    return names;
}

/// A problem about one value, at its place.
void refuseAt(Problem& problem, const std::string& where, ErrorCode code, Sentence message) {
    if (!problem)
        problem = Error{code, std::move(message), atPointer(where)};
}

void refuseValue(Problem& problem, const std::string& where, std::string_view expected, const Json& found) {
    refuseAt(problem, where, ErrorCode::Malformed,
             Sentence("expected {0}, found {1}", expected, foundText(found)));
}

/// One of an enumeration, by its name.
template<Enumerated E>
void readChoice(const Json& json, const std::string& where, Problem& problem, E& target) {
    if (!json.is_string())
        return refuseValue(problem, where, "a text", json);
    const auto& name = json.get_ref<const std::string&>();
    const auto rows = EnumTable<E>::rows;
    const auto found = std::ranges::find(rows, std::string_view(name), &EnumRow::name);
    if (found == rows.end())
        return refuseAt(problem, where, ErrorCode::OutOfRange,
                        Sentence("there is no {0}; {1}", ProperName{inQuotes(name)},
                                 suggestName(name, namesOfRows<E>())));
    target = static_cast<E>(found->value);
}

/// A file's name that stays in the suite's folder.
bool readFileName(const Json& json, const std::string& where, Problem& problem, std::string& target) {
    if (!json.is_string()) {
        refuseValue(problem, where, "a file's name", json);
        return false;
    }
    target = json.get<std::string>();
    if (target.size() > maxSuiteTextBytes) {
        refuseAt(problem, where, ErrorCode::TooLarge,
                 Sentence("expected at most {0} bytes, found {1}", maxSuiteTextBytes, target.size()));
        return false;
    }
    const Result<void> inside = checkInside(target);
    if (!inside)
        refuseAt(problem, where, inside.error().code, inside.error().message);
    return inside.has_value();
}

bool parseExtent(std::string_view text, int& extent) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), extent);
    return error == std::errc() && end == text.data() + text.size() && extent >= 1 &&
           extent <= maxPictureSize;
}

void readSize(const Json& json, const std::string& where, Problem& problem, PictureSize& size) {
    const std::string text = json.is_string() ? json.get<std::string>() : std::string();
    const std::size_t x = text.find('x');
    if (x == std::string::npos || !parseExtent(std::string_view(text).substr(0, x), size.width) ||
        !parseExtent(std::string_view(text).substr(x + 1), size.height))
        refuseValue(problem, where,
                    fmt::format("a size of 1x1 to {0}x{0} pixels, as in \"512x512\"", maxPictureSize), json);
}

void readTime(const Json& json, const std::string& where, Problem& problem, double& time) {
    constexpr double max = 1e6;
    if (json.is_number() && json.get<double>() >= 0 && json.get<double>() <= max)
        time = json.get<double>();
    else
        refuseValue(problem, where, fmt::format("seconds from 0 to {}", max), json);
}

/// A list, or one alone: the list of before is replaced. None may be there twice.
template<class T, class Read>
void readSeveral(JsonObject& object, const char* key, std::size_t max, std::vector<T>& target,
                 const Read& read) {
    std::vector<T> values;
    const bool isThere = object.oneOrMore(key, max, [&](const Json& json, const std::string& where) {
        T value{};
        read(json, where, object.problem(), value);
        if (std::ranges::find(values, value) != values.end())
            refuseAt(object.problem(), where, ErrorCode::Malformed,
                     Sentence("expected each once, found {0} again", foundText(json)));
        values.push_back(std::move(value));
    });
    if (isThere)
        target = std::move(values);
}

void readPattern(const Json& json, const std::string& where, Problem& problem, std::string& pattern) {
    if (!readFileName(json, where, problem, pattern))
        return;
    if (!pattern.ends_with(pictureExtension))
        return refuseValue(problem, where, "a name that ends in .png", json);
    for (std::size_t at = pattern.find('{'); at != std::string::npos; at = pattern.find('{', at + 1)) {
        const std::size_t end = pattern.find('}', at);
        const std::string_view name = std::string_view(pattern).substr(
            at + 1, end == std::string::npos ? std::string::npos : end - at - 1);
        if (end == std::string::npos || std::ranges::find(placeholders, name) == placeholders.end())
            return refuseValue(problem, where, "{case}, {picture} or {driver} between braces", json);
    }
}

void readPatterns(const Json& json, const std::string& where, Problem& problem,
                  std::vector<std::string>& patterns) {
    if (!json.is_array()) {
        readPattern(json, where, problem, patterns.emplace_back());
    } else if (json.empty() || json.size() > maxGoldens) {
        refuseAt(problem, where, ErrorCode::Malformed,
                 Sentence("expected a list of 1 to {0}, found {1}", maxGoldens, json.size()));
    } else {
        for (std::size_t i = 0; i < json.size() && !problem; ++i)
            readPattern(json[i], fmt::format("{}/{}", where, i), problem, patterns.emplace_back());
    }
}

void readGolden(const Json& json, const std::string& where, Problem& problem, Golden& golden) {
    if (json == "reference") {
        golden = GoldenReference{};
        return;
    }
    GoldenFiles files;
    if (json.is_object()) {
        if (json.empty() || json.size() > maxGoldens)
            return refuseAt(problem, where, ErrorCode::Malformed,
                            Sentence("expected 1 to {0} drivers, found {1}", maxGoldens, json.size()));
        for (const auto& [driver, patterns] : json.items()) {
            files.drivers.push_back({driver, {}});
            readPatterns(patterns, fmt::format("{}/{}", where, pointerStep(shortened(driver))), problem,
                         files.drivers.back().patterns);
        }
        // An object's members have no order: the glob that says most is the first.
        std::ranges::stable_sort(files.drivers, std::ranges::greater{},
                                 [](const GoldenFiles::ForDriver& each) { return each.driver.size(); });
    } else {
        files.drivers.push_back({"*", {}});
        readPatterns(json, where, problem, files.drivers.back().patterns);
    }
    golden = std::move(files);
}

/// 0.001, or "0.1%", as --share has it.
void readShare(JsonObject& object, double& share) {
    const Json* value = object.find("share");
    if (!value || !value->is_string())
        return object.number("share", share, 0, 1);
    const auto& text = value->get_ref<const std::string&>();
    if (!text.ends_with('%'))
        return refuseValue(object.problem(), object.placeOf("share"), "a number, or a text in percent",
                           *value);
    const Result<double> parsed = parseShare(text);
    if (parsed)
        share = *parsed;
    else
        object.say(parsed.error().code, "share", parsed.error().message);
}

/// "metric", "tolerance" and so on.
void readCriterion(JsonObject& object, Criterion& criterion) {
    if (const Json* metric = object.find("metric")) {
        Metric chosen = criterion.metric;
        readChoice(*metric, object.placeOf("metric"), object.problem(), chosen);
        if (chosen != criterion.metric) // a tolerance of before was in another unit
            criterion.tolerance = criterionOf(chosen).tolerance;
        criterion.metric = chosen;
    }
    object.number("tolerance", criterion.tolerance, 0, factsOf(criterion.metric).maxValue);
    readShare(object, criterion.share);
    bool rgb = criterion.compared == Compared::Rgb;
    object.flag("rgb", rgb);
    criterion.compared = rgb ? Compared::Rgb : Compared::Rgba;
    object.number("pixelsPerDegree", criterion.pixelsPerDegree, minPixelsPerDegree, maxPixelsPerDegree);
}

/// "rule" and what else is said of how alike two pictures have to be.
void readBounds(JsonObject& object, Settings& settings) {
    readCriterion(object, settings.criterion);
    const Json* rule = object.find("rule");
    if (!rule)
        return;
    auto* reference = std::get_if<GoldenReference>(&settings.golden);
    if (!reference)
        return object.say(ErrorCode::Malformed, "rule", "a rule applies only to \"golden\": \"reference\"");
    const std::string name = rule->is_string() ? rule->get<std::string>() : std::string();
    const auto names = ruleNames();
    if (std::ranges::find(names, std::string_view(name)) == names.end())
        return object.say(ErrorCode::OutOfRange, "rule",
                          Sentence("there is no rule {0}; {1}", foundText(*rule),
                                   suggestName(name, {names.begin(), names.end()})));
    reference->rule = name;
}

void readSettings(JsonObject& object, Settings& settings) {
    readSeveral(object, "size", maxScenes, settings.sizes, readSize);
    readSeveral(object, "time", maxScenes, settings.times, readTime);
    readSeveral(object, "renderer", EnumTable<RendererKind>::rows.size(), settings.renderers,
                readChoice<RendererKind>);
    if (const Json* golden = object.find("golden"))
        readGolden(*golden, object.placeOf("golden"), object.problem(), settings.golden);
    readBounds(object, settings);
    if (const Json* mask = object.find("mask"); mask && *mask == "")
        settings.mask.clear();
    else if (mask)
        readFileName(*mask, object.placeOf("mask"), object.problem(), settings.mask);
    object.number("seconds", settings.seconds, 0.001, maxCaseSeconds);
}

void readInlineScene(const Json& json, const std::string& where, Problem& problem, SceneInline& scene) {
    if (!json.is_object())
        return refuseValue(problem, where, "a scene as an object", json);
    scene.json = dumpJson(json);
    const Result<Scene> parsed = parseScene(scene.json);
    if (!parsed)
        problem = problem ? problem : within(atPointer(where), parsed.error());
}

void readLessonScene(JsonObject& object, SceneLesson& scene) {
    if (const Json* name = object.find("lesson"))
        readFileName(*name, object.placeOf("lesson"), object.problem(), scene.lesson);
    object.whole("step", scene.step, 1, lesson::maxSteps);
    object.whole("answer", scene.answer, 1, lesson::maxAnswers);
    object.flag("reached", scene.reached);
    if (scene.reached && scene.answer > 0)
        object.say(ErrorCode::Malformed, "", "expected one of answer and reached, found both");
}

void readExampleScene(JsonObject& object, SceneExample& scene) {
    object.text("example", scene.name, maxSuiteTextBytes);
    if (const Result<Scene> known = exampleScene(scene.name + ".json"); !known)
        object.say(known.error().code, "example", known.error().message);
}

void readScene(const Json& json, const std::string& where, Problem& problem, SceneSource& source) {
    if (!json.is_object()) {
        readFileName(json, where, problem, source.emplace<SceneFile>().file);
        return;
    }
    JsonObject object(json, where, problem);
    if (json.contains("example"))
        readExampleScene(object, source.emplace<SceneExample>());
    else if (json.contains("inline"))
        readInlineScene(*object.find("inline"), object.placeOf("inline"), problem,
                        source.emplace<SceneInline>());
    else if (json.contains("lesson"))
        readLessonScene(object, source.emplace<SceneLesson>());
    else
        object.say(ErrorCode::Malformed, "",
                   R"(expected a file's name, {"example": …}, {"lesson": …, "step": …} or {"inline": …})");
}

void readEdit(const Json& json, const std::string& where, Problem& problem, Edit& edit) {
    if (std::optional<Edit> read = parseEdit(json.is_string() ? json.get<std::string>() : std::string()))
        edit = *std::move(read);
    else
        refuseValue(problem, where, "PATH=VALUE or preset:NAME", json);
}

void readAxis(const Json& json, const std::string& where, Problem& problem, std::string& axis) {
    const std::string text = json.is_string() ? json.get<std::string>() : std::string();
    if (text.size() > maxSuiteTextBytes || text.find('=') == std::string::npos || text.front() == '=')
        return refuseValue(problem, where, "PATH=VALUES, as in \"textures[0].wrapS=*\"", json);
    axis = text;
}

/// What an entry says itself and what can't change its outcome: who wrote it believes that it does.
void refuseWithoutEffect(JsonObject& object, const Settings& settings) {
    const auto* reference = std::get_if<GoldenReference>(&settings.golden);
    if (reference &&
        std::ranges::find(settings.renderers, RendererKind::Reference) != settings.renderers.end())
        return object.say(ErrorCode::Malformed, "",
                          "\"golden\": \"reference\" has no effect with \"renderer\": \"reference\": it is "
                          "compared with itself");
    for (const char* key : boundKeys) {
        if (reference && reference->rule != "none" && object.find(key))
            return object.say(ErrorCode::Malformed, key,
                              "has no effect: the rule decides; \"rule\": \"none\" uses it");
    }
    if (object.find("pixelsPerDegree") && settings.criterion.metric != Metric::Flip)
        object.say(ErrorCode::Malformed, "pixelsPerDegree", "has no effect without \"metric\": \"flip\"");
}

void readEntry(const Json& json, const std::string& where, Problem& problem, Entry& entry) {
    JsonObject object(json, where, problem);
    object.text("name", entry.name, maxSuiteTextBytes);
    readSeveral(object, "scene", maxScenes, entry.scenes, readScene);
    object.oneOrMore("set", lesson::maxEdits, [&](const Json& each, const std::string& place) {
        readEdit(each, place, problem, entry.edits.emplace_back());
    });
    readSeveral(object, "axis", maxAxes, entry.axes, readAxis);
    readSettings(object, entry.settings);
    refuseWithoutEffect(object, entry.settings);
}

/// The same of what the defaults say, where no entry takes it.
void refuseDefaultsWithoutEffect(const Json& defaults, const std::vector<Entry>& entries, Problem& problem) {
    const bool rulesDecide = std::ranges::all_of(entries, [](const Entry& each) {
        const auto* reference = std::get_if<GoldenReference>(&each.settings.golden);
        return reference && reference->rule != "none";
    });
    for (const char* key : boundKeys) {
        if (rulesDecide && defaults.contains(key))
            refuseAt(problem, fmt::format("/defaults/{}", key), ErrorCode::Malformed,
                     "has no effect: a rule decides each case; \"rule\": \"none\" uses it");
    }
}

} // namespace

Result<Suite> parseSuite(std::string_view text) {
    const Result<Json> json = parseStrictJson(text, maxSuiteBytes);
    if (!json)
        return fail(json.error());
    Suite suite;
    Problem problem;
    {
        JsonObject object(*json, "", problem);
        object.find("$schema");
        readVersion(object, "suite", suiteFormatVersion);
        object.text("name", suite.name, maxSuiteTextBytes);
        object.text("about", suite.about, maxSuiteTextBytes);
        Settings defaults;
        if (const Json* settings = object.find("defaults")) {
            JsonObject of(*settings, "/defaults", problem);
            readSettings(of, defaults);
        }
        object.list("cases", 1, maxEntries, [&](const Json& each, const std::string& where) {
            Entry& entry = suite.entries.emplace_back();
            entry.settings = defaults;
            readEntry(each, where, problem, entry);
        });
        const Json* settings =
            json->is_object() && json->contains("defaults") ? &(*json)["defaults"] : nullptr;
        if (settings && settings->is_object())
            refuseDefaultsWithoutEffect(*settings, suite.entries, problem);
    }
    if (problem)
        return fail(*problem);
    return suite;
}

Result<Suite> readSuite(const std::filesystem::path& file) {
    const Result<std::string> text = readText(file, maxSuiteBytes);
    if (!text)
        return fail(text.error());
    Result<Suite> suite = parseSuite(*text);
    if (!suite)
        return fail(within(inFile(file.string()), suite.error()));
    suite->folder = file.parent_path();
    suite->file = file;
    if (suite->name.empty()) {
        const std::string name = file.filename().string();
        suite->name = name.ends_with(suiteExtension) ? name.substr(0, name.size() - suiteExtension.size())
                                                     : file.stem().string();
    }
    return suite;
}

} // namespace texplorer::suite
