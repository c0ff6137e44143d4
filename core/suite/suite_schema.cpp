#include "texplorer/scene/renderer.h"
#include "texplorer/suite/json_reader.h"
#include "texplorer/suite/rule_choice.h"
#include "texplorer/suite/suite.h"

#include <algorithm>

namespace texplorer::suite {
namespace {

template<Enumerated E>
OrderedJson choicesOf() {
    OrderedJson names = OrderedJson::array();
    for (const EnumRow& each : EnumTable<E>::rows)
        names.push_back(each.name);
    return {{"enum", std::move(names)}};
}

OrderedJson textSchema(const char* pattern = nullptr) {
    OrderedJson schema{{"type", "string"}, {"maxLength", maxSuiteTextBytes}};
    if (pattern)
        schema["pattern"] = pattern;
    return schema;
}

OrderedJson numberSchema(double min, double max) {
    return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
}

OrderedJson wholeSchema(std::size_t min, std::size_t max) {
    return {{"type", "integer"}, {"minimum", min}, {"maximum", max}};
}

OrderedJson strictObject(OrderedJson properties, OrderedJson required) {
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

/// One alone, or a list.
OrderedJson oneOrMore(const OrderedJson& each, std::size_t max, std::string_view description,
                      bool unique = true) {
    OrderedJson list{{"type", "array"}, {"items", each}, {"minItems", 1}, {"maxItems", max}};
    if (unique)
        list["uniqueItems"] = true;
    return {{"description", description}, {"anyOf", {each, std::move(list)}}};
}

OrderedJson described(OrderedJson schema, std::string_view description) {
    schema["description"] = description;
    return schema;
}

constexpr const char* insideFolder = R"(^(?!/)(?!(?:.*/)?\.\.(?:/|$))[^\\\x00-\x1f]+$)";
constexpr const char* goldenPattern =
    R"(^(?!/)(?!(?:.*/)?\.\.(?:/|$))(?:[^\\{\x00-\x1f]|\{case\}|\{picture\}|\{driver\})+\.png$)";
constexpr const char* sharePattern = R"(^0*(?:100(?:\.0+)?|[0-9]{1,2}(?:\.[0-9]+)?)%$)";

/// "1x1" to "16384x16384", however many zeros stand before a number.
std::string sizePattern() {
    static_assert(maxPictureSize == 16384);
    const std::string extent = "0*(?:[1-9][0-9]{0,3}|1[0-5][0-9]{3}|16[0-2][0-9]{2}|163[0-7][0-9]|1638[0-4])";
    return "^" + extent + "x" + extent + "$";
}

/// A member that is this word.
OrderedJson isThis(const char* key, std::string_view word) {
    return {{"properties", {{key, {{"const", word}}}}}, {"required", {key}}};
}

OrderedJson hasKey(const char* key) {
    return {{"required", {key}}};
}

OrderedJson notThis(OrderedJson schema) {
    return {{"not", std::move(schema)}};
}

OrderedJson ifThen(OrderedJson condition, OrderedJson then) {
    return {{"if", std::move(condition)}, {"then", std::move(then)}};
}

OrderedJson toleranceUpTo(double largest) {
    return {{"properties", {{"tolerance", {{"maximum", largest}}}}}};
}

/// The restrictions of settings that depend on their metric, rule or golden.
OrderedJson settingsRules() {
    OrderedJson rules = OrderedJson::array();
    for (const EnumRow& each : EnumTable<Metric>::rows)
        rules.push_back(ifThen(isThis("metric", each.name),
                               toleranceUpTo(factsOf(static_cast<Metric>(each.value)).maxValue)));
    rules.push_back(ifThen({{"required", {"rule", "golden"}}}, isThis("golden", "reference")));
    return rules;
}

/// What the reference as golden leaves without effect.
OrderedJson entryRules() {
    OrderedJson rules = settingsRules();
    OrderedJson bounds = OrderedJson::array();
    for (const char* key : {"metric", "tolerance", "share", "rgb", "pixelsPerDegree"})
        bounds.push_back(hasKey(key));
    const OrderedJson takesNone = notThis(isThis("rule", "none"));
    rules.push_back(
        ifThen({{"allOf", {isThis("golden", "reference"), takesNone}}}, notThis({{"anyOf", bounds}})));
    const OrderedJson isReference{{"const", "reference"}};
    const OrderedJson drawsIt{
        {"properties",
         {{"renderer", {{"anyOf", {isReference, {{"contains", isReference}, {"type", "array"}}}}}}}},
        {"required", {"renderer"}}};
    rules.push_back(ifThen(isThis("golden", "reference"), notThis(drawsIt)));
    return rules;
}

OrderedJson ofEachCase(OrderedJson schema) {
    return {{"properties", {{"cases", {{"items", std::move(schema)}}}}}};
}

OrderedJson ofDefaults(OrderedJson schema) {
    return {{"properties", {{"defaults", std::move(schema)}}}, {"required", {"defaults"}}};
}

/// What an entry takes over from the defaults decides as if it said it itself.
OrderedJson suiteRules() {
    OrderedJson rules = OrderedJson::array();
    for (const EnumRow& each : EnumTable<Metric>::rows) {
        const auto metric = static_cast<Metric>(each.value);
        const OrderedJson said = ofDefaults(isThis("metric", each.name));
        const OrderedJson unsaid = notThis(ofDefaults(hasKey("metric")));
        rules.push_back(
            ifThen(metric == Criterion{}.metric ? OrderedJson{{"anyOf", {said, unsaid}}} : said,
                   ofEachCase(ifThen(notThis(hasKey("metric")), toleranceUpTo(factsOf(metric).maxValue)))));
    }
    const OrderedJson ownReference = ifThen(hasKey("rule"), isThis("golden", "reference"));
    rules.push_back(ifThen(notThis(ofDefaults(isThis("golden", "reference"))),
                           {{"allOf", {ofEachCase(ownReference), notThis(ofDefaults(hasKey("rule")))}}}));
    return rules;
}

OrderedJson goldenSchema() {
    const OrderedJson one = textSchema(goldenPattern);
    const OrderedJson files = oneOrMore(one, maxGoldens, "pictures, any of which may match", false);
    return {{"description",
             "The expected picture: stored pictures, any of which may match; the same for each driver, by "
             "globs of its renderer string; or the reference. In a name {case} is the case, {picture} the "
             "case without its renderer, so that renderers share a picture, and {driver} the driver. "
             "Default: golden/{case}.png."},
            {"anyOf",
             {OrderedJson{{"const", "reference"}}, files,
              OrderedJson{{"type", "object"},
                          {"additionalProperties", files},
                          {"minProperties", 1},
                          {"maxProperties", maxGoldens}}}}};
}

OrderedJson settingsProperties() {
    OrderedJson rules = OrderedJson::array();
    for (const std::string_view name : ruleNames())
        rules.push_back(name);
    const OrderedJson size = textSchema(sizePattern().c_str());
    double largest = 0;
    for (const EnumRow& each : EnumTable<Metric>::rows)
        largest = std::max(largest, factsOf(static_cast<Metric>(each.value)).maxValue);
    return {
        {"size", oneOrMore(size, maxScenes, "\"512x512\": width and height in pixels")},
        {"time", oneOrMore(numberSchema(0, 1e6), maxScenes, "the scene's time in seconds")},
        {"renderer",
         oneOrMore(choicesOf<RendererKind>(), EnumTable<RendererKind>::rows.size(), "the renderer")},
        {"golden", goldenSchema()},
        {"rule",
         described(
             OrderedJson{{"enum", std::move(rules)}},
             "With the reference as golden: the rule for differences, one of \"texshot conform --list\"; "
             "\"auto\" selects the rule of the scene, \"none\" uses tolerance and share.")},
        {"metric", described(choicesOf<Metric>(), "how a pixel's difference is measured")},
        {"tolerance",
         described(numberSchema(0, largest), "the maximum difference of a pixel, in the unit of the metric")},
        {"share", described(OrderedJson{{"anyOf", {numberSchema(0, 1), textSchema(sharePattern)}}},
                            "the share of pixels that may differ by more: 0.001 or \"0.1%\"")},
        {"rgb", described(OrderedJson{{"type", "boolean"}}, "ignores alpha")},
        {"pixelsPerDegree", described(numberSchema(minPixelsPerDegree, maxPixelsPerDegree),
                                      "flip: the pixels per degree of the viewer's field of view")},
        {"mask", described(OrderedJson{{"anyOf", {OrderedJson{{"const", ""}}, textSchema(insideFolder)}}},
                           "a picture whose black pixels are ignored; empty: none")},
        {"seconds", described(numberSchema(0.001, maxCaseSeconds), "the time limit of a case in seconds")},
    };
}

OrderedJson sceneSchema() {
    OrderedJson lesson = strictObject({{"lesson", textSchema(insideFolder)},
                                       {"step", wholeSchema(1, lesson::maxSteps)},
                                       {"answer", wholeSchema(1, lesson::maxAnswers)},
                                       {"reached", {{"type", "boolean"}}}},
                                      {"lesson"});
    return {{"anyOf",
             {textSchema(insideFolder), strictObject({{"example", textSchema()}}, {"example"}),
              std::move(lesson), strictObject({{"inline", {{"type", "object"}}}}, {"inline"})}}};
}

OrderedJson entrySchema() {
    OrderedJson properties{
        {"name", described(textSchema(), "the beginning of its cases' names; default: the scene's name")},
        {"scene",
         oneOrMore(sceneSchema(), maxScenes,
                   "files, examples, steps of lessons or complete scenes; default: the start scene")},
        {"set", oneOrMore(textSchema("^(preset:.+|[^=]+=)"), lesson::maxEdits,
                          "PATH=VALUE or preset:NAME, in this order", false)},
        {"axis", oneOrMore(textSchema("^[^=]+="), maxAxes,
                           "PATH=VALUES: a case for each value, or for each combination of several axes")},
    };
    properties.update(settingsProperties());
    OrderedJson schema = strictObject(std::move(properties), OrderedJson::array());
    schema["allOf"] = entryRules();
    return schema;
}

} // namespace

std::string suiteSchema() {
    OrderedJson defaults = strictObject(settingsProperties(), OrderedJson::array());
    defaults["allOf"] = settingsRules();
    OrderedJson properties{
        {"$schema", {{"type", "string"}}},
        {"suite", described(wholeSchema(1, suiteFormatVersion), "the version of the format")},
        {"name", described(textSchema(), "its name in reports; default: the file's name")},
        {"about", textSchema()},
        {"defaults", described(std::move(defaults), "the defaults of all entries")},
        {"cases", {{"type", "array"}, {"items", entrySchema()}, {"minItems", 1}, {"maxItems", maxEntries}}},
    };
    OrderedJson schema = strictObject(std::move(properties), {"suite", "cases"});
    schema["allOf"] = suiteRules();
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    schema["$id"] = "file:///usr/share/texplorer/suite.schema.json"; // where the Debian package installs it
    schema["title"] = "A suite of pictures for texshot test";
    return dumpJson(schema, 2) + "\n";
}

} // namespace texplorer::suite
