#include "app/screenshot/output/json_text.h"
#include "app/screenshot/reports/probe_report.h"
#include "texplorer/reference/explain/explanation_steps.h"
#include "texplorer/reference/explain/sampling_steps.h"
#include "texplorer/reference/explain/stored_texel.h"
#include "texplorer/reference/explain/texel_bytes.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;
using namespace reference;

/// An average over an ellipse has thousands.
constexpr std::size_t maxListedTaps = 1024;

Json listOf(glm::vec3 v) {
    return Json::array({v.x, v.y, v.z});
}
Json listOf(glm::vec4 v) {
    return Json::array({v.x, v.y, v.z, v.w});
}
Json listOf(glm::ivec3 v) {
    return Json::array({v.x, v.y, v.z});
}
Json listOf(const PixelBytes& bytes) {
    Json list = Json::array();
    for (const std::uint8_t byte : bytes)
        list.push_back(int{byte});
    return list;
}

template<Enumerated E>
Json nameOf(E value) {
    return std::string(rowOf(value).name);
}

Json jsonOf(const CoordinateSteps& steps) {
    return {{"given", listOf(steps.given)},
            {"embossed", listOf(steps.embossed)},
            {"generated", listOf(steps.generated)},
            {"transformed", listOf(steps.transformed)}};
}

Json jsonOf(const VertexExplanation& vertex) {
    Json json{{"vertex", vertex.vertex},           {"weight", vertex.weight},
              {"object", listOf(vertex.object)},   {"eye", listOf(vertex.eye)},
              {"normal", listOf(vertex.normal)},   {"clip", listOf(vertex.clip)},
              {"primary", listOf(vertex.primary)}, {"secondary", listOf(vertex.secondary)}};
    if (vertex.lighting)
        json["lighting"] = {{"emission", listOf(vertex.lighting->emission)},
                            {"scene", listOf(vertex.lighting->scene)},
                            {"ambient", listOf(vertex.lighting->ambient)},
                            {"diffuse", listOf(vertex.lighting->diffuse)},
                            {"specular", listOf(vertex.lighting->specular)},
                            {"nDotVP", vertex.lighting->nDotVP},
                            {"nDotH", vertex.lighting->nDotH}};
    return json;
}

Json jsonOf(const Equation& equation) {
    return {{"symbols", equation.symbols}, {"numbers", equation.numbers}};
}

Json jsonOf(const SampleRecord& sample, const UnitExplanation& unit) {
    const Lod& lod = sample.lod;
    Json json{{"lod",
               {{"texelsPerPixelX", lod.lengthX},
                {"texelsPerPixelY", lod.lengthY},
                {"probes", lod.probes},
                {"ellipse", lod.ellipse},
                {"line", lod.line},
                {"rhoMethod", nameOf(lod.method)},
                {"rho", lod.rho},
                {"log2Rho", lod.base},
                {"textureBias", unit.sampler.lodBias},
                {"unitBias", unit.lodBias},
                {"bias", lod.bias},
                {"biased", lod.biased},
                {"lambda", lod.lambda},
                {"c", lod.switchOver},
                {"magnified", lod.magnified},
                {"undefined", lod.undefined},
                {"why", whyMagnified(unit)}}}};
    Json& levels = json["levels"] = Json::array();
    for (const LevelShare& share : sample.levels) {
        Json entry{{"level", share.level}, {"weight", share.weight}};
        for (const LevelExtent& extent : unit.extents) {
            if (extent.level == share.level)
                entry["size"] = listOf(extent.size);
        }
        levels.push_back(std::move(entry));
    }
    Json& probes = json["probes"] = Json::array();
    for (const glm::vec3& probe : sample.probes)
        probes.push_back(listOf(probe));
    Json& wrapped = json["wrapped"] = Json::array();
    for (const WrappedCoordinate& each : sample.wrapped)
        wrapped.push_back({{"level", each.level},
                           {"axis", std::string(1, "str"[each.axis])},
                           {"wrap", nameOf(each.wrap)},
                           {"given", each.given},
                           {"texels", each.texels}});
    Json& taps = json["taps"] = Json::array();
    for (const Tap& tap : std::span(sample.taps).first(std::min(sample.taps.size(), maxListedTaps))) {
        Json entry{{"level", tap.level},
                   {"index", listOf(tap.index)},
                   {"weight", tap.weight},
                   {"color", listOf(tap.color)},
                   {"border", tap.border}};
        const auto stored = storedTexel(unit.internalFormat, tap.color);
        if (stored && !tap.border)
            entry["stored"] = {{"numbers", stored->numbers}, {"largest", stored->max}};
        if (const auto bytes = unit.uploaded ? texelBytes(*unit.uploaded, unit.target, tap) : std::nullopt)
            entry["memory"] = {{"first", bytes->range.first},
                               {"count", bytes->range.count},
                               {"bytes", bytes->values},
                               {"holds", bytes->holds},
                               {"readAs", bytes->readAs}};
        if (isDepth(unit.internalFormat))
            entry["depth"] = tap.depth;
        taps.push_back(std::move(entry));
    }
    json["tapCount"] = sample.taps.size();
    if (sample.cube) {
        json["face"] = rowOf(cubeFaceAt(sample.cube->face)).label;
        json["seamless"] = sample.seamless;
    }
    json["color"] = listOf(sample.color);
    return json;
}

Json jsonOf(const Tie& tie) {
    constexpr std::array names{"texels", "levels", "filters", "faces"};
    Json json{{"between", names.at(static_cast<std::size_t>(tie.between))},
              {"chosen", tie.chosen},
              {"other", tie.other}};
    if (tie.between == Tie::Between::Texels) {
        json["level"] = tie.level;
        json["axis"] = std::string(1, "str"[tie.axis]);
    }
    return json;
}

template<class T>
Json arrayOf(const std::vector<T>& elements) {
    Json array = Json::array();
    for (const T& each : elements)
        array.push_back(jsonOf(each));
    return array;
}

Json jsonOf(const UnitExplanation& unit) {
    Json preparation = Json::array();
    for (const ImageOp op : unit.preparation)
        preparation.push_back(nameOf(op));
    Json json{{"unit", unit.unit},
              {"texture", unit.texture},
              {"target", nameOf(unit.target)},
              {"baseFormat", nameOf(unit.format)},
              {"internalFormat", nameOf(unit.internalFormat)},
              {"picture", unit.picture},
              {"preparation", preparation},
              {"generates",
               Json::array({unit.generates[0], unit.generates[1], unit.generates[2], unit.generates[3]})},
              {"atVertices", arrayOf(unit.vertices)},
              {"here", jsonOf(unit.pixel)},
              {"coords", listOf(unit.coords)},
              {"perPixelX", listOf(unit.derivatives.dx)},
              {"perPixelY", listOf(unit.derivatives.dy)},
              {"magFilter", nameOf(unit.sampler.magFilter)},
              {"minFilter", nameOf(unit.sampler.minFilter)}};
    for (std::size_t i = 0; i < unit.vertices.size(); ++i) {
        const std::optional<std::uint32_t> of = unit.vertices[i].of;
        json["atVertices"][i]["givenOf"] = of ? Json(*of) : Json();
    }
    if (isDepth(unit.internalFormat)) {
        json["compareMode"] = nameOf(unit.sampler.compareMode);
        json["compareFunc"] = nameOf(unit.sampler.compareFunc);
        json["depthMode"] = nameOf(unit.sampler.depthMode);
    }
    json["sample"] = jsonOf(unit.sample, unit);
    json["ties"] = arrayOf(unit.ties.ties);
    json["environment"] = {{"mode", nameOf(unit.mode)},
                           {"previous", listOf(unit.inputs.previous)},
                           {"source", listOf(unit.inputs.source)},
                           {"constant", listOf(unit.inputs.constant)},
                           {"primary", listOf(unit.inputs.primary)},
                           {"color", jsonOf(unit.equations.color)},
                           {"alpha", jsonOf(unit.equations.alpha)},
                           {"undefined", unit.equations.undefined},
                           {"result", listOf(unit.result)}};
    return json;
}

template<class T>
Json jsonOf(const TestExplanation<T>& test) {
    return {{"enabled", test.enabled},
            {"function", nameOf(test.function)},
            {"value", test.value},
            {"with", test.with},
            {"passed", test.passed}};
}

Json jsonOf(const BlendExplanation& blend) {
    if (!blend.enabled)
        return {{"enabled", false}};
    return {{"enabled", true},
            {"sourceFactor", nameOf(blend.sourceFactor)},
            {"destinationFactor", nameOf(blend.destinationFactor)},
            {"source", listOf(blend.source)},
            {"sourceWeight", listOf(blend.sourceWeight)},
            {"destination", listOf(blend.destination)},
            {"destinationWeight", listOf(blend.destinationWeight)},
            {"result", listOf(blend.result)}};
}

Json jsonOf(const std::optional<FogExplanation>& fog) {
    if (!fog)
        return {{"enabled", false}};
    return {{"enabled", true},           {"mode", nameOf(fog->state.mode)},
            {"distance", fog->distance}, {"equation", jsonOf(fog->equation)},
            {"factor", fog->factor},     {"fogColor", listOf(fog->state.color)}};
}

Json jsonOf(const FragmentExplanation& fragment) {
    constexpr std::array partNames{"point", "line", "triangle"};
    constexpr std::array outcomes{"drawn", "failed the alpha test", "failed the depth test"};
    Json json{{"pass", fragment.pass},
              {"model", fragment.model},
              {"shape", nameOf(fragment.shape)},
              {"face", fragment.face},
              {"part", partNames.at(std::clamp<std::size_t>(fragment.vertices.size(), 1, 3) - 1)},
              {"number", fragment.part},
              {"clipped", fragment.clipped},
              {"outcome", outcomes.at(static_cast<std::size_t>(fragment.outcome))},
              {"vertices", arrayOf(fragment.vertices)},
              {"lighting", fragment.lighting},
              {"flat", fragment.flat},
              {"twoSided", fragment.twoSided},
              {"fromBehind", fragment.fromBehind},
              {"primary", listOf(fragment.primary)}};
    Json& units = json["units"] = Json::array();
    for (const UnitExplanation& unit : fragment.units)
        units.push_back(jsonOf(unit));
    Json& idle = json["unitsWithoutEffect"] = Json::array();
    for (const IdleUnit& unit : fragment.idle)
        idle.push_back({{"unit", unit.unit}, {"reason", unit.reason}});
    json["textured"] = listOf(fragment.textured);
    json["separateSpecular"] = fragment.separateSpecular;
    json["secondary"] = listOf(fragment.secondary);
    json["summed"] = listOf(fragment.summed);
    json["fog"] = jsonOf(fragment.fog);
    json["color"] = listOf(fragment.color);
    json["alphaTest"] = jsonOf(fragment.alphaTest);
    json["depth"] = fragment.depth;
    json["depthTest"] = jsonOf(fragment.depthTest);
    json["blend"] = jsonOf(fragment.blend);
    json["before"] = listOf(fragment.before);
    json["after"] = listOf(fragment.after);
    return json;
}

} // namespace

std::string asJson(const Explanation& explanation, const std::vector<ReadBack>& readBacks) {
    const auto& [x, y] = explanation.pixel;
    Json json{{"at", Json::array({x, explanation.height - 1 - y})},
              {"window", Json::array({x, y})},
              {"width", explanation.width},
              {"height", explanation.height},
              {"time", explanation.time},
              {"reference", listOf(explanation.bytes)}};
    Json& asRight = json["asRight"] = Json::array();
    for (const PixelBytes& each : explanation.asRight)
        asRight.push_back(listOf(each));
    for (const ReadBack& each : readBacks) {
        const std::string name(rowOf(each.renderer).name);
        if (each.bytes)
            json[name] = listOf(*each.bytes);
        else
            json[name] = {{"error", problemJson(each.bytes.error())}};
    }
    json["color"] = listOf(explanation.color);
    json["background"] = listOf(explanation.background);
    json["fragmentCount"] = explanation.fragmentCount;
    json["firstFragment"] = explanation.firstFragment;
    Json& fragments = json["fragments"] = Json::array();
    for (const FragmentExplanation& fragment : explanation.fragments)
        fragments.push_back(jsonOf(fragment));
    json["notes"] = messagesJson(explanation.problems);
    return documentText(Json::array({std::move(json)}));
}

Result<void> writeJson(const Contributions& found, const TexelQuestion& question,
                       const std::function<Result<void>(std::string_view)>& write) {
    const Json head{{"pass", question.pass},         {"unit", question.unit},
                    {"level", question.texel.level}, {"texel", listOf(question.texel.index)},
                    {"width", found.width},          {"height", found.height},
                    {"pixels", Json::array()}}; // x, y from the top left, weight
    std::string text = documentText(Json::array({head}));
    const std::size_t place = text.find("\"pixels\": []") + std::string_view("\"pixels\": [").size();
    const std::string end = text.substr(place);
    text.resize(place);
    bool isFirst = true;
    for (int y = found.height - 1; y >= 0; --y) {
        const float* weights =
            found.weights.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(found.width);
        for (int x = 0; x < found.width; ++x) {
            if (!(weights[x] > 0))
                continue;
            text += isFirst ? "\n        [" : ",\n        [";
            text += fmt::format("{}, {}, {}]", x, found.height - 1 - y, formatNumber(weights[x]));
            isFirst = false;
        }
        if (text.empty())
            continue;
        if (Result<void> written = write(text); !written)
            return written;
        text.clear();
    }
    return write((isFirst ? "" : "\n      ") + end);
}

} // namespace texplorer::screenshot
