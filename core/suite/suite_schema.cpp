#include "core/scene/renderer.h"
#include "core/suite/json_reader.h"
#include "core/suite/rule_choice.h"
#include "core/suite/suite.h"

#include <fmt/core.h>

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

OrderedJson numberSchema(double lowest, double highest) {
    return {{"type", "number"}, {"minimum", lowest}, {"maximum", highest}};
}

OrderedJson wholeSchema(std::size_t lowest, std::size_t highest) {
    return {{"type", "integer"}, {"minimum", lowest}, {"maximum", highest}};
}

OrderedJson strictObject(OrderedJson properties, OrderedJson required) {
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
}

/// One alone, or a list.
OrderedJson oneOrMore(const OrderedJson& each, std::size_t most, std::string_view description,
                      bool unique = true) {
    OrderedJson list{{"type", "array"}, {"items", each}, {"minItems", 1}, {"maxItems", most}};
    if (unique)
        list["uniqueItems"] = true;
    return {{"description", description}, {"anyOf", {each, std::move(list)}}};
}

OrderedJson described(OrderedJson schema, std::string_view description) {
    schema["description"] = description;
    return schema;
}

constexpr const char* insideFolder = R"(^(?!/)(?!(?:.*/)?\.\.(?:/|$))[^\\]+$)";
constexpr const char* goldenPattern =
    R"(^(?!/)(?!(?:.*/)?\.\.(?:/|$))(?:[^\\{]|\{case\}|\{picture\}|\{driver\})+\.png$)";

OrderedJson goldenSchema() {
    const OrderedJson one = textSchema(goldenPattern);
    const OrderedJson files = oneOrMore(one, maxGoldens, "pictures, any of which will do", false);
    return {{"description",
             "What the picture is held against: stored pictures, any of which will do; the same for "
             "each driver, by globs of its renderer string; or the reference. In a name {case} is the case, "
             "{picture} the case without its renderer, so that several renderers share it, and {driver} the "
             "driver. Without it: golden/{case}.png."},
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
    const OrderedJson size = textSchema("^[1-9][0-9]{0,4}x[1-9][0-9]{0,4}$");
    return {
        {"size", oneOrMore(size, maxScenes, "\"512x512\": width and height in pixels")},
        {"time", oneOrMore(numberSchema(0, 1e6), maxScenes, "seconds of the scene's own time")},
        {"renderer",
         oneOrMore(choicesOf<RendererKind>(), EnumTable<RendererKind>::rows.size(), "what draws it")},
        {"golden", goldenSchema()},
        {"rule",
         described(
             OrderedJson{{"enum", std::move(rules)}},
             "Of the reference as golden: how far a driver may be from it, as texshot conform lists the "
             "rules; \"auto\" finds the one for the scene, \"none\" takes tolerance and share.")},
        {"metric", described(choicesOf<Metric>(), "in what a pixel's difference is measured")},
        {"tolerance", described(numberSchema(0, 255), "what a pixel may differ by, in the metric's unit")},
        {"share", described(numberSchema(0, 1), "how many of the pixels may differ by more")},
        {"mask", described(textSchema(), "a picture whose black pixels don't count")},
        {"seconds", described(numberSchema(0.001, maxCaseSeconds), "after which a case has hung")},
    };
}

OrderedJson sceneSchema() {
    OrderedJson lesson = strictObject({{"lesson", textSchema(insideFolder)},
                                       {"step", wholeSchema(1, lesson::maxSteps)},
                                       {"answer", wholeSchema(1, lesson::mostAnswers)},
                                       {"reached", {{"type", "boolean"}}}},
                                      {"lesson"});
    return {{"anyOf",
             {textSchema(insideFolder), strictObject({{"example", textSchema()}}, {"example"}),
              std::move(lesson), strictObject({{"inline", {{"type", "object"}}}}, {"inline"})}}};
}

OrderedJson entrySchema() {
    OrderedJson properties{
        {"name", described(textSchema(), "what its cases' names begin with; without it, the scene's")},
        {"scene",
         oneOrMore(sceneSchema(), maxScenes,
                   "files, examples, steps of lessons or scenes written out here; without it, what the "
                   "program starts with")},
        {"set", oneOrMore(textSchema("^(preset:.+|[^=]+=)"), lesson::maxEdits,
                          "PATH=VALUE or preset:NAME, in this order", false)},
        {"axis", oneOrMore(textSchema("^[^=]+="), maxAxes,
                           "PATH=VALUES: a case for each value, and of several axes for each combination")},
    };
    properties.update(settingsProperties());
    return strictObject(std::move(properties), OrderedJson::array());
}

} // namespace

std::string suiteSchema() {
    OrderedJson properties{
        {"$schema", {{"type", "string"}}},
        {"suite", described(wholeSchema(1, suiteFormatVersion), "the version of the format")},
        {"name", described(textSchema(), "what reports call it; without it, the file's name")},
        {"about", textSchema()},
        {"defaults", described(strictObject(settingsProperties(), OrderedJson::array()),
                               "what holds for every entry that doesn't say otherwise")},
        {"cases", {{"type", "array"}, {"items", entrySchema()}, {"minItems", 1}, {"maxItems", maxEntries}}},
    };
    OrderedJson schema = strictObject(std::move(properties), {"suite", "cases"});
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    schema["$id"] = "file:///usr/share/texplorer/suite.schema.json"; // where the Debian package installs it
    schema["title"] = "A suite of pictures for texshot test";
    return dumpJson(schema, 2) + "\n";
}

} // namespace texplorer::suite
