#include "app/ui/model/consequence.h"

#include "app/ui/model/explaining.h"
#include "texplorer/reference/explain/explanation_steps.h"
#include "texplorer/reference/sampling/comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace texplorer::ui {
namespace {

using reference::LevelShare;
using reference::UnitExplanation;

/// "4", "1.5", "120"
std::string timesText(double factor) {
    return factor < 9.95 ? fmt::format("{:g}", std::round(factor * 10) / 10) : fmt::format("{:.0f}", factor);
}

/// Linear filtering reads 2 texels of a line, 4 of a picture, 8 of a volume.
int neighbours(Target target) {
    return target == Target::Texture1D ? 2 : target == Target::Texture3D ? 8 : 4;
}

Sentence magnifiedText(const UnitExplanation& unit, ProperName times) {
    if (unit.sample.lod.probes > 1)
        return Sentence("Magnified {0}×: {1} samples along the footprint", times, unit.sample.lod.probes);
    return unit.sampler.magFilter == MagFilter::Nearest
               ? Sentence("Magnified {0}×: the nearest texel", times)
               : Sentence("Magnified {0}×: linear, of {1} texels", times, neighbours(unit.target));
}

Sentence levelText(MinFilter filter, ProperName times, int level) {
    switch (filter) {
    case MinFilter::Nearest:
        return Sentence("Minified {0}×: the nearest texel of level {1}, without mipmaps", times, level);
    case MinFilter::Linear:
        return Sentence("Minified {0}×: linear in level {1}, without mipmaps", times, level);
    case MinFilter::NearestMipmapNearest:
    case MinFilter::NearestMipmapLinear:
        return Sentence("Minified {0}×: the nearest texel of level {1}", times, level);
    case MinFilter::LinearMipmapNearest:
    case MinFilter::LinearMipmapLinear:
        break;
    }
    return Sentence("Minified {0}×: linear in level {1}", times, level);
}

struct Sign {
    CompareFunc function;
    const char* sign;
};

// GL_NEVER compares nothing, GL_ALWAYS drops nothing.
constexpr std::array compareSigns{
    Sign{CompareFunc::Less, "<"},    Sign{CompareFunc::LessEqual, "<="},    Sign{CompareFunc::Equal, "="},
    Sign{CompareFunc::Greater, ">"}, Sign{CompareFunc::GreaterEqual, ">="}, Sign{CompareFunc::NotEqual, "!="},
};

/// "" of what compares nothing.
std::string_view signOf(CompareFunc function) {
    const auto* found = std::ranges::find(compareSigns, function, &Sign::function);
    return found != compareSigns.end() ? found->sign : "";
}

Sentence alphaFailedText(const reference::TestExplanation<float>& test) {
    const std::string_view sign = signOf(test.function);
    if (sign.empty())
        return N_("The alpha test drops the fragment: nothing passes GL_NEVER");
    // Compared are bytes: two alphas may be one there.
    const bool needsBytes = reference::passes<float>(test.function, test.value, test.with);
    const auto shown = [&](float alpha) {
        return needsBytes ? fmt::format("{:.0f}/255", std::floor(std::clamp(alpha, 0.0F, 1.0F) * 255 + 0.5F))
                          : reference::numberText(alpha);
    };
    return Sentence("The alpha test drops the fragment: {0} is not {1} {2}", ProperName{shown(test.value)},
                    ProperName{sign}, ProperName{shown(test.with)});
}

Sentence depthFailedText(const reference::TestExplanation<std::uint32_t>& test) {
    const std::string_view sign = signOf(test.function);
    if (sign.empty())
        return N_("The depth test drops the fragment: nothing passes GL_NEVER");
    const auto shown = [](std::uint32_t depth) {
        return reference::numberText(static_cast<float>(depth) / 16777215.0F); // 24 bits
    };
    const bool differ = shown(test.value) != shown(test.with);
    return Sentence("The depth test drops the fragment: {0} is not {1} {2}",
                    ProperName{differ ? shown(test.value) : std::to_string(test.value)}, ProperName{sign},
                    ProperName{differ ? shown(test.with) : std::to_string(test.with)});
}

/// Of a pixel that shows nothing but the background: why the nearest fragment isn't there.
Sentence nothingDrawnText(const reference::Explanation& explanation) {
    const auto closest =
        std::ranges::min_element(explanation.fragments, {}, &reference::FragmentExplanation::depth);
    if (closest == explanation.fragments.end())
        return N_("The background: nothing is drawn at this pixel");
    return closest->outcome == reference::FragmentOutcome::FailedAlphaTest
               ? alphaFailedText(closest->alphaTest)
               : depthFailedText(closest->depthTest);
}

} // namespace

Sentence consequenceOf(const UnitExplanation& unit) {
    const reference::Lod& lod = unit.sample.lod;
    std::vector<LevelShare> levels = unit.sample.levels;
    std::erase_if(levels, [](const LevelShare& share) { return share.weight <= 0; });
    if (levels.empty() || !std::isfinite(lod.rho) || lod.rho <= 0)
        return N_("The level of detail is undefined here");
    if (lod.magnified)
        return magnifiedText(unit, {timesText(1 / lod.rho)});
    const std::string factor = timesText(lod.rho);
    const ProperName times{factor};
    const bool isAlong = lod.probes > 1;
    if (levels.size() == 1)
        return isAlong ? Sentence("Minified {0}×: {1} samples along the footprint, level {2}", times,
                                  lod.probes, levels.front().level)
                       : levelText(unit.sampler.minFilter, times, levels.front().level);
    const int first = static_cast<int>(std::lround(100 * levels[0].weight));
    if (isAlong)
        return Sentence(
            "Minified {0}×: {1} samples along the footprint, {2} % of level {3}, {4} % of level {5}", times,
            lod.probes, first, levels[0].level, 100 - first, levels[1].level);
    return Sentence("Minified {0}×: {1} % of level {2}, {3} % of level {4}", times, first, levels[0].level,
                    100 - first, levels[1].level);
}

Sentence consequenceOf(const Session& session) {
    const reference::Explanation* explanation = explanationOf(session);
    if (!explanation)
        return {};
    if (const UnitExplanation* unit = probedUnit(session))
        return consequenceOf(*unit);
    const reference::FragmentExplanation* seen = explanation->seen();
    if (!seen)
        return nothingDrawnText(*explanation);
    if (seen->units.empty())
        return N_("No texture is applied at this pixel");
    return consequenceOf(seen->units.front());
}

Sentence stateOf(const Document& document) {
    const Sentence edit = document.history.undoName();
    const std::string name = document.file.filename().string();
    if (!isDirty(document))
        return name.empty() ? N_("Nothing to save yet") : Sentence("{0} is saved", ProperName{name});
    return edit.empty() ? N_("Not saved") : Sentence("Changed last: {0} · not saved", edit);
}

} // namespace texplorer::ui
