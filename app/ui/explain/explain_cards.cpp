#include "app/ui/explain/explain_cards.h"

#include "texplorer/base/translatable.h"
#include "texplorer/reference/explain/sampling_steps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

using reference::FragmentExplanation;
using reference::Ink;
using reference::StepKind;
using reference::UnitExplanation;

/// In the order of StepKind.
constexpr std::array stageOfSteps{Stage::Vertices, Stage::Vertices, Stage::Coordinates, Stage::LevelOfDetail,
                                  Stage::Texels,   Stage::Filter,   Stage::Environment, Stage::IdleUnit,
                                  Stage::ColorSum, Stage::Fog,      Stage::Tests,       Stage::Tests,
                                  Stage::Tests,    Stage::Pixel};
static_assert(stageOfSteps.size() == static_cast<std::size_t>(StepKind::Framebuffer) + 1);

using Lines = std::vector<CardLine>;

CardLine colorLine(glm::vec4 color) {
    return {fmt::format("{:.2f} {:.2f} {:.2f}", color.r, color.g, color.b)};
}

Lines verticesLines(const FragmentExplanation& fragment) {
    Lines lines;
    for (const reference::VertexExplanation& vertex : fragment.vertices)
        lines.push_back({fmt::format("{}: {} %", vertex.vertex, reference::percentText(vertex.weight))});
    return lines;
}

Lines coordinatesLines(const UnitExplanation& unit) {
    constexpr std::array names{"s", "t", "r"};
    constexpr std::array inks{Ink::S, Ink::T, Ink::R};
    const bool compares = isDepth(unit.internalFormat) && unit.sampler.compareMode == CompareMode::RToTexture;
    const int count = compares ? 3 : coordinatesOf(unit.target);
    Lines lines;
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        lines.push_back(
            {fmt::format("{} {}", names.at(index), reference::numberText(unit.coords[i])), inks.at(index)});
    }
    return lines;
}

Lines lodLines(const UnitExplanation& unit) {
    const reference::Lod& lod = unit.sample.lod;
    Lines lines{{fmt::format("λ {}", reference::lambdaText(lod))}};
    const bool isFactor = std::isfinite(lod.rho) && lod.rho > 0;
    lines.push_back({lod.magnified ? isFactor && lod.rho < 1 ? Sentence("magnified {0:.3g}×", 1 / lod.rho)
                                                             : N_("magnified")
                     : isFactor && lod.rho > 1 ? Sentence("minified {0:.3g}×", lod.rho)
                                               : N_("minified")});
    if (lod.ellipse)
        lines.push_back({N_("over an ellipse")});
    else if (lod.probes > 1)
        lines.push_back({Sentence("{0} probes", lod.probes)});
    return lines;
}

Lines texelsLines(const UnitExplanation& unit) {
    const bool border = std::ranges::any_of(unit.sample.taps, &reference::Tap::border);
    const std::size_t count = reference::texelCount(unit.sample);
    const auto& levels = unit.sample.levels;
    Lines lines{{count == 1 ? N_("1 texel") : Sentence("{0} texels", count)}};
    if (levels.size() == 1)
        lines.push_back({Sentence("level {0}", levels[0].level)});
    else if (levels.size() > 1)
        lines.push_back({Sentence("levels {0}, {1}", levels[0].level, levels[1].level)});
    if (border)
        lines.push_back({N_("with border")});
    else if (!unit.ties.ties.empty())
        lines.push_back({N_("a tie: either")});
    return lines;
}

Lines filterLines(const UnitExplanation& unit) {
    const auto& levels = unit.sample.levels;
    const glm::vec4 color = unit.sample.color;
    if (levels.size() < 2)
        return {{unit.sample.lod.magnified ? rowOf(unit.sampler.magFilter).label
                                           : rowOf(unit.sampler.minFilter).label},
                colorLine(color),
                {Sentence("alpha {0:.2f}", color.a)}};
    Lines lines;
    for (const reference::LevelShare& share : levels)
        lines.push_back(
            {Sentence("level {0}: {1} %", share.level, ProperName{reference::percentText(share.weight)})});
    lines.push_back(colorLine(color)); // shows transparency: a card has no fourth line
    if (std::lround(color.a * 100) < 100)
        lines.back().text = fmt::format("{} {:.2f}", lines.back().text.english(), color.a);
    return lines;
}

Lines environmentLines(const UnitExplanation& unit) {
    return {{rowOf(unit.mode).label, unit.equations.undefined ? Ink::Bad : Ink::Plain},
            colorLine(unit.result),
            {Sentence("alpha {0:.2f}", unit.result.a)}};
}

Lines testsLines(const FragmentExplanation& fragment) {
    const auto line = [](const auto& test, const char* off, const char* passed, const char* failed) {
        return !test.enabled ? CardLine{off, Ink::Dim}
               : test.passed ? CardLine{passed, Ink::Good}
                             : CardLine{failed, Ink::Bad};
    };
    Lines lines{line(fragment.alphaTest, N_("alpha: off"), N_("alpha: passed"), N_("alpha: failed")),
                line(fragment.depthTest, N_("depth: off"), N_("depth: passed"), N_("depth: failed"))};
    if (fragment.outcome == reference::FragmentOutcome::Drawn)
        lines.push_back(fragment.blend.enabled ? CardLine{N_("blending: on")}
                                               : CardLine{N_("blending: off"), Ink::Dim});
    return lines;
}

Lines pixelLines(const FragmentExplanation& fragment) {
    const reference::PixelBytes& bytes = fragment.after;
    return {{fmt::format("{} {} {}", bytes[0], bytes[1], bytes[2])}, {Sentence("alpha {0}", bytes[3])}};
}

Lines stageLines(Stage stage, const FragmentExplanation& fragment, const UnitExplanation* unit) {
    switch (stage) {
    case Stage::Vertices:
        return verticesLines(fragment);
    case Stage::Coordinates:
        return coordinatesLines(*unit);
    case Stage::LevelOfDetail:
        return lodLines(*unit);
    case Stage::Texels:
        return texelsLines(*unit);
    case Stage::Filter:
        return filterLines(*unit);
    case Stage::Environment:
        return environmentLines(*unit);
    case Stage::IdleUnit:
        return {{N_("as if it were off"), Ink::Bad}};
    case Stage::ColorSum:
        return {colorLine(fragment.summed)};
    case Stage::Fog:
        return {{fmt::format("f {}", reference::numberText(fragment.fog->factor))},
                colorLine(fragment.color)};
    case Stage::Tests:
        return testsLines(fragment);
    case Stage::Pixel:
        break;
    }
    return pixelLines(fragment);
}

} // namespace

std::vector<Card> cardsOf(const FragmentExplanation& fragment, const reference::FragmentSteps& steps) {
    const bool severalUnits = fragment.units.size() + fragment.idle.size() > 1;
    std::vector<Card> cards;
    for (std::size_t i = 0; i < steps.steps.size(); ++i) {
        const reference::Step& step = steps.steps[i];
        const Stage stage = stageOfSteps.at(static_cast<std::size_t>(step.kind));
        if (!cards.empty() && cards.back().stage == stage && cards.back().unit == step.unit) {
            cards.back().steps.push_back(i);
            continue;
        }
        const auto unit = std::ranges::find(fragment.units, step.unit, &UnitExplanation::unit);
        Card& card = cards.emplace_back(Card{stage, step.unit, rowOf(stage).name, {}, {i}});
        if (step.unit >= 0 && severalUnits)
            card.name = Sentence("{0}, unit {1}", rowOf(stage).name, step.unit);
        card.lines = stageLines(stage, fragment, unit == fragment.units.end() ? nullptr : &*unit);
    }
    return cards;
}

const Card* sameCard(const std::vector<Card>& cards, const Card& card) {
    const auto found = std::ranges::find_if(
        cards, [&](const Card& other) { return other.stage == card.stage && other.unit == card.unit; });
    return found == cards.end() ? nullptr : &*found;
}

} // namespace texplorer::ui
