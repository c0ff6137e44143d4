#include "texplorer/reference/explain/explanation_steps.h"

#include "texplorer/reference/explain/sampling_steps.h"
#include "texplorer/reference/sampling/comparison.h"
#include "texplorer/reference/shading/equation_text.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texplorer::reference {

namespace {

/// From here on a power of ten is shorter.
constexpr float maxPlain = 1e6F;

std::string vectorText(glm::vec3 v) {
    return fmt::format("({}, {}, {})", columnText(v.x), columnText(v.y), columnText(v.z));
}

std::string colorText(glm::vec4 c) {
    return fmt::format("{} {} {} {}", numberText(c.r), numberText(c.g), numberText(c.b), numberText(c.a));
}

constexpr const char* switchedOff = N_("off");

/// The heading of a table with a column for each corner.
StepRow corners(const FragmentExplanation& fragment) {
    StepRow row{N_("vertex"), {}, {}, true};
    for (const VertexExplanation& vertex : fragment.vertices)
        row.cells.push_back({std::to_string(vertex.vertex), Ink::Dim});
    return row;
}

/// One line of such a table.
template<class Text>
StepRow perCorner(const char* label, const FragmentExplanation& fragment, Text&& text) {
    StepRow row{label};
    for (const VertexExplanation& vertex : fragment.vertices)
        row.cells.push_back({text(vertex)});
    return row;
}

/// What the mesh is made of: by the number of corners.
struct PartWords {
    const char* title;
    const char* name;
};
PartWords partWords(const FragmentExplanation& fragment) {
    constexpr std::array words{PartWords{N_("Point"), N_("point")}, PartWords{N_("Line"), N_("line")},
                               PartWords{N_("Triangle"), N_("triangle")}};
    return words.at(std::clamp<std::size_t>(fragment.vertices.size(), 1, 3) - 1);
}

Step triangleStep(const FragmentExplanation& fragment) {
    Step step{StepKind::Triangle, -1, partWords(fragment).title, {}};
    std::string shares;
    for (const VertexExplanation& vertex : fragment.vertices) {
        shares += fmt::format("{}{} %", shares.empty() ? "" : ", ", percentText(vertex.weight));
    }
    step.summary = shares;
    step.rows = {
        corners(fragment),
        perCorner("share here", fragment, [](const auto& v) { return columnText(v.weight); }),
        perCorner("x, y, z of the model", fragment,
                  [](const auto& v) { return vectorText(glm::vec3(v.object)); }),
        perCorner("in eye coordinates", fragment, [](const auto& v) { return vectorText(glm::vec3(v.eye)); }),
        perCorner("normal there", fragment, [](const auto& v) { return vectorText(v.normal); }),
        // Translators: the fourth coordinate
        perCorner("w", fragment, [](const auto& v) { return columnText(v.clip.w); })};
    if (fragment.clipped)
        step.rows.push_back({N_(
            "It extends beyond the view and was clipped. The shares are those of the original vertices.")});
    return step;
}

Step primaryStep(const FragmentExplanation& fragment) {
    Step step{StepKind::PrimaryColor, -1, N_("Primary colour"), colorText(fragment.primary),
              fragment.primary};
    if (!fragment.lighting) {
        if (fragment.coloredVertices)
            step.rows = {{N_("Lighting is off: the colours of the vertices, interpolated.")},
                         corners(fragment),
                         perCorner("colour", fragment, [](const auto& v) { return colorText(v.primary); })};
        else
            step.rows = {{N_("Lighting is off: the current colour (glColor), the same at every vertex.")}};
        return step;
    }
    const auto term = [](glm::vec3 LightingTerms::*member) {
        return [member](const VertexExplanation& v) { return vectorText((*v.lighting).*member); };
    };
    step.rows = {
        corners(fragment),
        perCorner("cosine, normal to light", fragment,
                  [](const auto& v) { return columnText(v.lighting->nDotVP); }),
        perCorner("cosine, normal to half-way", fragment,
                  [](const auto& v) { return columnText(v.lighting->nDotH); }),
        perCorner("scene's ambient", fragment, term(&LightingTerms::scene)),
        perCorner("+ ambient", fragment, term(&LightingTerms::ambient)),
        perCorner("+ diffuse", fragment, term(&LightingTerms::diffuse)),
        perCorner(fragment.separateSpecular ? N_("specular, apart") : N_("+ specular"), fragment,
                  term(&LightingTerms::specular)),
        perCorner("= primary, clamped", fragment,
                  [](const auto& v) { return vectorText(glm::vec3(v.primary)); }),
    };
    const bool emits = std::ranges::any_of(
        fragment.vertices, [](const VertexExplanation& v) { return v.lighting->emission != glm::vec3(0); });
    if (emits)
        step.rows.insert(step.rows.begin() + 3,
                         perCorner("emission", fragment, term(&LightingTerms::emission)));
    if (fragment.twoSided && fragment.vertices.size() == 3)
        step.rows.push_back({fragment.fromBehind ? N_("Seen from behind: lit with the opposite normal "
                                                      "(GL_LIGHT_MODEL_TWO_SIDE).")
                                                 : N_("Seen from the front: lit with the normal.")});
    else if (fragment.fromBehind)
        step.rows.push_back({N_("Seen from behind, and lit as the front (GL_LIGHT_MODEL_TWO_SIDE is off).")});
    step.rows.push_back({fragment.flat ? N_("Flat shading: the colour of the last vertex.")
                                       : N_("Smooth shading: interpolated between the vertices.")});
    if (fragment.separateSpecular)
        step.rows.push_back({N_("secondary, after texturing"),
                             {{vectorText(glm::vec3(fragment.secondary))}},
                             glm::vec4(glm::vec3(fragment.secondary), 1)});
    return step;
}

Step environmentStep(const UnitExplanation& unit) {
    Step step{StepKind::Environment, unit.unit, N_("Environment"), {}};
    step.summary =
        Sentence("{0}: {1}", ProperName{rowOf(unit.mode).name}, ProperName{colorText(unit.result)});
    step.swatch = unit.result;
    const auto input = [&](const char* label, glm::vec4 color) {
        StepRow row{label, {}, color};
        for (int i = 0; i < 4; ++i)
            row.cells.push_back({numberText(color[i])});
        step.rows.push_back(std::move(row));
    };
    step.rows.push_back(componentHeading(""));
    input(N_("Cp, Ap: incoming"), unit.inputs.previous);
    input(N_("Cs, As: texture"), unit.inputs.source);
    const std::string written = unit.equations.color.symbols + unit.equations.alpha.symbols;
    if (written.find("Cc") != std::string::npos || written.find("Ac") != std::string::npos)
        input(N_("Cc, Ac: constant"), unit.inputs.constant);
    if (written.find("Cf") != std::string::npos || written.find("Af") != std::string::npos)
        input(N_("Cf, Af: primary"), unit.inputs.primary);
    step.rows.push_back({unit.equations.color.symbols, {}, {}, false, Ink::Dim});
    for (std::size_t i = 0; i < unit.equations.color.numbers.size(); ++i)
        step.rows.push_back(
            {componentNames.at(std::min<std::size_t>(i, 2)), {{unit.equations.color.numbers[i]}}});
    step.rows.push_back({unit.equations.alpha.symbols, {}, {}, false, Ink::Dim});
    for (const Sentence& numbers : unit.equations.alpha.numbers)
        step.rows.push_back({componentNames[3], {{numbers}}});
    if (unit.equations.undefined)
        step.rows.push_back(
            {unit.mode == EnvMode::Combine
                 ? Sentence("Undefined: an argument is the texture of a unit without a texture. The "
                            "incoming colour is passed on.")
                 : Sentence("{0} is undefined for {1}: the incoming colour is passed on.",
                            ProperName{rowOf(unit.mode).name}, ProperName{rowOf(unit.format).name}),
             {},
             {},
             false,
             Ink::Bad});
    return step;
}

Step colorSumStep(const FragmentExplanation& fragment) {
    Step step{StepKind::ColorSum, -1, N_("Colour sum"), colorText(fragment.summed), fragment.summed};
    for (int i = 0; i < 3; ++i) {
        const float sum = fragment.textured[i] + fragment.secondary[i];
        const std::string addends =
            fmt::format("{} + {}", numberText(fragment.textured[i]), numberText(fragment.secondary[i]));
        step.rows.push_back({componentNames.at(static_cast<std::size_t>(i)), {{withResult(addends, sum)}}});
    }
    return step;
}

Step fogStep(const FragmentExplanation& fragment, const FogExplanation& fog) {
    Step step{StepKind::Fog, -1, N_("Fog"), colorText(fragment.color), fragment.color};
    const glm::vec4 color = glm::clamp(fog.state.color, 0.0F, 1.0F);
    step.rows = {{N_("mode"), {{std::string(rowOf(fog.state.mode).name)}}},
                 {N_("c: distance from the eye's plane"), {{numberText(fog.distance)}}},
                 {fog.equation.symbols, {}, {}, false, Ink::Dim}};
    for (const Sentence& numbers : fog.equation.numbers)
        step.rows.push_back({"f", {{numbers}}});
    step.rows.push_back({N_("f, clamped"), {{numberText(fog.factor)}}});
    step.rows.push_back({N_("Cr: before"), {{colorText(fragment.summed)}}, fragment.summed});
    step.rows.push_back(
        {N_("Cf: fog colour"), {{vectorText(glm::vec3(color))}}, glm::vec4(glm::vec3(color), 1)});
    step.rows.push_back({N_("C = f * Cr + (1 - f) * Cf"), {}, {}, false, Ink::Dim});
    for (int i = 0; i < 3; ++i)
        step.rows.push_back(
            {componentNames.at(static_cast<std::size_t>(i)),
             {{fmt::format(
                 "{} = {}",
                 inNumbers(N_("f * Cr + (1 - f) * Cf"),
                           {{"f", fog.factor}, {N_("Cr"), fragment.summed[i]}, {N_("Cf"), color[i]}}),
                 numberText(fragment.color[i]))}}});
    step.rows.push_back({N_("Alpha is unchanged.")});
    return step;
}

template<class T>
Step testStep(StepKind kind, const char* title, const TestExplanation<T>& test, const std::string& value,
              const std::string& with) {
    Step step{kind, -1, title, switchedOff};
    if (!test.enabled)
        return step;
    step.summary = Sentence("{0} {1} {2}: {3}", ProperName{value}, ProperName{rowOf(test.function).name},
                            ProperName{with}, test.passed ? N_("passed") : N_("failed"));
    step.rows = {{N_("of the fragment"), {{value}}},
                 {kind == StepKind::AlphaTest ? N_("reference value") : N_("in the depth buffer"), {{with}}},
                 {test.passed ? N_("passed") : N_("failed: nothing is written"),
                  {},
                  {},
                  false,
                  test.passed ? Ink::Good : Ink::Bad}};
    return step;
}

/// Alphas as they are compared: in bytes, where these decide otherwise than the numbers that they stand for.
Step alphaTestStep(const TestExplanation<float>& test) {
    const bool needsBytes = passes<float>(test.function, test.value, test.with) != test.passed;
    const auto shown = [&](float alpha, float other) {
        return needsBytes ? fmt::format("{:.0f}/255", std::floor(glm::clamp(alpha, 0.0F, 1.0F) * 255 + 0.5F))
                          : numberText(alpha, other);
    };
    return testStep(StepKind::AlphaTest, N_("Alpha test"), test, shown(test.value, test.with),
                    shown(test.with, test.value));
}

std::string depthText(std::uint32_t depth) {
    return fmt::format("{} ({})", depth, numberText(static_cast<float>(depth) / 16777215.0F));
}

Step blendStep(const FragmentExplanation& fragment) {
    const BlendExplanation& blend = fragment.blend;
    Step step{StepKind::Blending, -1, N_("Blending"), switchedOff};
    if (!blend.enabled)
        return step;
    step.summary = colorText(blend.result);
    step.swatch = blend.result;
    step.rows.push_back({Sentence("source {0}", ProperName{colorText(blend.source)}), {}, blend.source});
    step.rows.push_back({indented(Sentence("times {0}", ProperName{rowOf(blend.sourceFactor).name})),
                         {{colorText(blend.sourceWeight)}}});
    step.rows.push_back(
        {Sentence("destination {0}", ProperName{colorText(blend.destination)}), {}, blend.destination});
    step.rows.push_back({indented(Sentence("times {0}", ProperName{rowOf(blend.destinationFactor).name})),
                         {{colorText(blend.destinationWeight)}}});
    for (int i = 0; i < 4; ++i)
        step.rows.push_back(
            {componentNames.at(static_cast<std::size_t>(i)),
             {{fmt::format("{} * {} + {} * {} = {}", numberText(blend.source[i]),
                           numberText(blend.sourceWeight[i]), numberText(blend.destination[i]),
                           numberText(blend.destinationWeight[i]), numberText(blend.result[i]))}}});
    return step;
}

glm::vec4 colorOfBytes(const PixelBytes& bytes) {
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0F;
}

Step framebufferStep(const FragmentExplanation& fragment) {
    Step step{StepKind::Framebuffer, -1, N_("Framebuffer"), bytesText(fragment.after),
              colorOfBytes(fragment.after)};
    step.rows = {{N_("before"), {{bytesText(fragment.before)}}, colorOfBytes(fragment.before)},
                 {N_("after"), {{bytesText(fragment.after)}}, colorOfBytes(fragment.after)}};
    return step;
}

} // namespace

std::string numberText(float value) {
    if (std::abs(value) < maxPlain || !std::isfinite(value))
        return shortNumber(value);
    return fmt::format("{:.3g}", value);
}

std::string numberText(float value, float other) {
    const std::string number = numberText(value);
    return value != other && number == numberText(other) ? fmt::format("{}", value) : number;
}

std::string percentText(float share) {
    constexpr float rounding = 1e-5F; // what is nearer is 0 or 1 and was interpolated
    const float percent = std::round(share * 1000) / 10;
    if (percent == 0 && share > rounding)
        return "< 0.1";
    return percent == 100 && share < 1 - rounding ? "> 99.9" : numberText(percent);
}

std::string amountText(float value) {
    const std::string text = numberText(value);
    return text != "0" || value == 0 ? text : value > 0 ? "< 0.0001" : "> -0.0001";
}

std::string columnText(float value, int digits) {
    if (!(std::abs(value) < maxPlain))
        return numberText(value);
    const std::string number = fmt::format("{:.{}f}", value, digits);
    const bool isZero = number.find_first_of("123456789") == std::string::npos;
    return isZero && number.front() == '-' ? number.substr(1) : number;
}

Sentence indented(const Sentence& label) {
    return Sentence("  {0}", label);
}

StepRow componentHeading(Sentence label) {
    StepRow row{std::move(label), {}, {}, true};
    for (const char* name : componentNames)
        row.cells.push_back({name, Ink::Dim});
    return row;
}

std::string bytesText(const PixelBytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes)
        text += fmt::format("{}{}", text.empty() ? "" : " ", byte);
    return text;
}

FragmentSteps stepsOf(const FragmentExplanation& fragment) {
    FragmentSteps text;
    const std::string shape(rowOf(fragment.shape).label);
    const char* part = partWords(fragment).name;
    text.title = fragment.face.empty() || fragment.face == shape
                     ? Sentence("{0}, {1} {2} (models[{3}], pass {4})", shape, part, fragment.part,
                                fragment.model, fragment.pass)
                     : Sentence("{0}, {1}, {2} {3} (models[{4}], pass {5})", shape, fragment.face, part,
                                fragment.part, fragment.model, fragment.pass);
    text.drawn = fragment.outcome == FragmentOutcome::Drawn;
    text.outcome = fragment.outcome == FragmentOutcome::FailedAlphaTest   ? N_("failed the alpha test")
                   : fragment.outcome == FragmentOutcome::FailedDepthTest ? N_("failed the depth test")
                                                                          : N_("drawn");
    std::vector<Step>& steps = text.steps;
    steps.push_back(triangleStep(fragment));
    steps.push_back(primaryStep(fragment));
    for (const UnitExplanation& unit : fragment.units) {
        for (Step& step : samplingSteps(fragment, unit))
            steps.push_back(std::move(step));
        steps.push_back(environmentStep(unit));
    }
    for (const IdleUnit& idle : fragment.idle)
        steps.push_back({StepKind::IdleUnit,
                         idle.unit,
                         N_("Without effect"),
                         N_("as if it were off"),
                         {},
                         {{idle.reason, {}, {}, false, Ink::Bad}}});
    if (fragment.separateSpecular)
        steps.push_back(colorSumStep(fragment));
    if (fragment.fog)
        steps.push_back(fogStep(fragment, *fragment.fog));
    steps.push_back(alphaTestStep(fragment.alphaTest));
    steps.push_back(testStep(StepKind::DepthTest, N_("Depth test"), fragment.depthTest,
                             depthText(fragment.depthTest.value), depthText(fragment.depthTest.with)));
    if (text.drawn) {
        steps.push_back(blendStep(fragment));
        steps.push_back(framebufferStep(fragment));
    }
    return text;
}

Sentence cutSentence(const Explanation& explanation) {
    const std::size_t count = explanation.fragments.size();
    return count == explanation.fragmentCount
               ? Sentence()
               : Sentence("{0} fragments cover it. Numbers {1} to {2} are explained (at most {3}).",
                          explanation.fragmentCount, explanation.firstFragment + 1,
                          explanation.firstFragment + count, maxExplainedFragments);
}

int differenceOf(const PixelBytes& one, const PixelBytes& other) {
    int most = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        most = std::max(most, std::abs(int{one[i]} - int{other[i]}));
    return most;
}

bool isAsRight(const Explanation& explanation, const PixelBytes& bytes, int tolerance) {
    return std::ranges::any_of(
        explanation.asRight, [&](const PixelBytes& each) { return differenceOf(each, bytes) <= tolerance; });
}

std::vector<FragmentSteps> stepsOf(const Explanation& explanation) {
    std::vector<FragmentSteps> all;
    for (const FragmentExplanation& fragment : explanation.fragments)
        all.push_back(stepsOf(fragment));
    return all;
}

} // namespace texplorer::reference
