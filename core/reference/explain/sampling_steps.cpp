#include "texplorer/reference/explain/sampling_steps.h"

#include "texplorer/reference/explain/coordinate_steps.h"
#include "texplorer/reference/explain/stored_texel.h"
#include "texplorer/reference/explain/texel_bytes.h"
#include "texplorer/reference/sampling/depth_texel.h"
#include "texplorer/reference/sampling/wrap.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

namespace {

/// A filter of so many samples or fewer is shown as it is, tap by tap.
constexpr std::size_t fewTaps = 8;
constexpr std::size_t maxTapsShown = 48;

/// Of depths, whose last digits decide.
constexpr int depthDigits = 6;
constexpr int allDigits = 9; ///< of a float

/// Of the coordinates of one pixel and the next, in which small numbers count.
constexpr int derivativeDigits = 6;

std::string percent(float share) {
    return percentText(share) + " %";
}

/// Whether the filter that decided blends neighbours.
bool isLinearHere(const UnitExplanation& unit) {
    if (unit.sample.lod.line)
        return true;
    return unit.sample.lod.magnified ? unit.sampler.magFilter == MagFilter::Linear
                                     : isLinear(unit.sampler.minFilter);
}

Step lodStep(const UnitExplanation& unit) {
    const Lod& lod = unit.sample.lod;
    const int axes = axesOf(unit.target);
    Step step{StepKind::LevelOfDetail, unit.unit, N_("Level of detail"), {}};
    step.summary = Sentence("lambda {0}: {1}", ProperName{lambdaText(lod)},
                            lod.magnified ? N_("magnified") : N_("minified"));
    const Derivatives& change = unit.sample.cube ? unit.sample.cube->derivatives : unit.derivatives;
    step.rows.push_back(
        heading(unit.sample.cube ? N_("from pixel to pixel, on the face") : N_("from pixel to pixel"), axes));
    step.rows.push_back(coordinates(indented("d/dx"), glm::vec4(change.dx, 0), axes, derivativeDigits));
    step.rows.push_back(coordinates(indented("d/dy"), glm::vec4(change.dy, 0), axes, derivativeDigits));
    const auto value = [&](Sentence label, double number) {
        step.rows.push_back({std::move(label), {{amountText(static_cast<float>(number))}}});
    };
    value(N_("texels a pixel, in x"), lod.lengthX);
    value(N_("texels a pixel, in y"), lod.lengthY);
    const std::string limit = numberText(unit.sampler.maxAnisotropy);
    if (lod.ellipse)
        step.rows.push_back({Sentence(
            "anisotropic, up to {0}: averaged over the ellipse that the pixel covers, whatever the filters are",
            ProperName{limit})});
    else if (lod.line)
        value(Sentence("anisotropic, up to {0}: samples of one level along a line, whatever the filters are",
                       ProperName{limit}),
              lod.probes);
    else if (lod.probes > 1)
        value(Sentence("anisotropic, up to {0}: probes", ProperName{limit}), static_cast<float>(lod.probes));
    value(lod.ellipse || lod.line          ? "rho"
          : lod.probes > 1                 ? N_("rho = the longer, divided by the probes")
          : lod.method == RhoMethod::Lower ? N_("rho = the largest derivative of u, v and w")
          : lod.method == RhoMethod::Upper ? N_("rho = the largest derivatives of u, v and w, added")
                                           : N_("rho = the longer"),
          lod.rho);
    value("log2(rho)", lod.base);
    if (unit.sampler.lodBias != 0)
        value(N_("+ LOD bias of the texture"), unit.sampler.lodBias);
    if (unit.lodBias != 0)
        value(N_("+ LOD bias of the unit"), unit.lodBias);
    if (lod.bias != unit.sampler.lodBias + unit.lodBias)
        step.rows.push_back(
            {unit.sampler.lodBias != 0 && unit.lodBias != 0 ? N_("together clamped to") : N_("clamped to"),
             {{numberText(lod.bias)}}});
    if (lod.lambda != lod.biased)
        step.rows.push_back({Sentence("clamped to {0} ... {1}", ProperName{numberText(unit.sampler.minLod)},
                                      ProperName{numberText(unit.sampler.maxLod)}),
                             {{lambdaText(lod)}}});
    if (!lod.ellipse && !lod.line)
        step.rows.push_back({whyMagnified(unit)});
    for (const Tie& tie : unit.ties.ties) {
        if (tie.between == Tie::Between::Levels)
            step.rows.push_back(
                {Sentence("lambda is half-way between level {0} and level {1}, within 1/64: either is "
                          "correct.",
                          std::min(tie.chosen, tie.other), std::max(tie.chosen, tie.other))});
        else if (tie.between == Tie::Between::Filters)
            step.rows.push_back(
                {Sentence("lambda is at the limit between {0} and {1}, within 1/64: either is correct.",
                          ProperName{rowOf(unit.sampler.magFilter).name},
                          ProperName{rowOf(unit.sampler.minFilter).name})});
    }
    if (lod.undefined)
        step.rows.push_back(
            {unit.sampler.minLod > unit.sampler.maxLod
                 ? N_("The min LOD is above the max LOD: undefined. The max LOD is used here.")
                 : N_("A derivative is infinite or not a number: undefined. rho is 1 here."),
             {},
             {},
             false,
             Ink::Bad});
    return step;
}

Sentence texelText(int index, int size, bool seamless) {
    return index >= 0 && index < size ? Sentence("texel {0}", index)
           : seamless                 ? N_("the next face")
                                      : N_("the border");
}

/// What wrapping makes of a coordinate, and where that is in a row of texels: "1.5179 → clamped to 1 → × 8 =
/// 8". Just below a whole number, which four digits would show, with all digits.
Sentence wrapText(const WrappedCoordinate& coordinate, int size) {
    const auto n = static_cast<float>(size);
    const float u = coordinate.texels;
    const std::string texels = numberText(u, std::max(u, std::round(u)));
    const auto text = [&](float number) {
        return texels == numberText(u) ? numberText(number) : fmt::format("{}", number);
    };
    const float s = definedCoordinate(coordinate.given);
    const bool counts = s == coordinate.given;
    const float place = coordinate.wrap == Wrap::MirroredRepeat ? mirror(s)
                        : coordinate.wrap == Wrap::Repeat       ? s - std::floor(s)
                                                                : u / n;
    const Sentence given =
        counts ? Sentence(ProperName{text(s)}) : Sentence("{0}, which counts as 0", coordinate.given);
    const auto scaled = [&](const std::string& product) {
        return Sentence("{0} → × {1} = {2}", given, size, ProperName{product});
    };
    if (coordinate.wrap == Wrap::Repeat)
        return place == s ? scaled(texels)
                          : Sentence("{0} → fraction {1} → × {2} = {3}", given, ProperName{text(place)}, size,
                                     ProperName{texels});
    if (coordinate.wrap == Wrap::MirroredRepeat) {
        const bool isClamped = place * n != u;
        const std::string product = isClamped ? numberText(place * n, u) : texels;
        const Sentence steps = place == s ? scaled(product)
                                          : Sentence("{0} → mirrored to {1} → × {2} = {3}", given,
                                                     ProperName{text(place)}, size, ProperName{product});
        return isClamped ? Sentence("{0}, clamped to {1}", steps, ProperName{texels}) : steps;
    }
    return s * n == u ? scaled(texels)
                      : Sentence("{0} → clamped to {1} → × {2} = {3}", given, ProperName{text(place)}, size,
                                 ProperName{texels});
}

/// The same, and which texel GL_NEAREST takes there.
Sentence nearestText(const WrappedCoordinate& coordinate, int size, bool seamless) {
    const Sentence steps = wrapText(coordinate, size);
    const int index = nearestTexel(coordinate.texels, size);
    if (index < 0 || index >= size)
        return seamless ? Sentence("{0} → the next face", steps) : Sentence("{0} → the border", steps);
    return coordinate.texels == static_cast<float>(size) ? Sentence("{0} → last texel, {1}", steps, index)
                                                         : Sentence("{0} → texel {1}", steps, index);
}

/// Between which texels of a row a linear filter blends. The centre of texel i is at i + 0.5.
Sentence linearText(const WrappedCoordinate& coordinate, int size, bool seamless) {
    const float u = coordinate.texels;
    const auto [first, second, share] = linearTexels(coordinate.wrap, u, size);
    return Sentence("- 0.5 = {0}: {1} and {2}, shares {3} and {4}", ProperName{numberText(u - 0.5F)},
                    texelText(first, size, seamless), texelText(second, size, seamless),
                    ProperName{numberText(1 - share)}, ProperName{numberText(share)});
}

/// Whether a sample reads three texels where the cube has a corner and no fourth.
bool isAtCorner(const UnitExplanation& unit, int level, int size) {
    int beyond = 0;
    for (const WrappedCoordinate& each : unit.sample.wrapped) {
        if (each.level != level || each.wrap != Wrap::ClampToBorder)
            continue;
        const TexelPair pair = linearTexels(each.wrap, each.texels, size);
        beyond += pair.first < 0 || (pair.second >= size && pair.share > 0) ? 1 : 0;
    }
    return unit.sample.seamless && unit.sample.probes.size() == 1 && beyond == 2;
}

Step wrapStep(const UnitExplanation& unit) {
    Step step{StepKind::Wrap, unit.unit, N_("Levels and wrapping"), {}};
    std::vector<Sentence> levels;
    for (const LevelShare& share : unit.sample.levels)
        levels.push_back(unit.sample.levels.size() > 1
                             ? Sentence("level {0}: {1}", share.level, ProperName{percent(share.weight)})
                             : Sentence("level {0}", share.level));
    step.summary = Sentence::joined("{0}, {1}", levels);
    for (const LevelExtent& extent : unit.extents) {
        std::string size = std::to_string(extent.size.x);
        for (int axis = 1; axis < axesOf(unit.target); ++axis)
            size += fmt::format(" × {}", extent.size[axis]);
        step.rows.push_back(
            {Sentence("level {0}", extent.level), {{Sentence("{0} texels", ProperName{size})}}, {}, true});
        for (int axis = 0; axis < axesOf(unit.target); ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            const auto found = std::ranges::find_if(unit.sample.wrapped, [&](const WrappedCoordinate& each) {
                return each.level == extent.level && each.axis == axis;
            });
            if (found == unit.sample.wrapped.end())
                continue;
            const int row = extent.size[axis];
            const bool seamless = unit.sample.seamless;
            const bool isNearest = !isLinearHere(unit) && !unit.sample.lod.ellipse; // which weighs all in it
            step.rows.push_back({indented(Sentence("{0}, {1}", ProperName{coordinateNames.at(i)},
                                                   seamless ? N_("seamless") : rowOf(found->wrap).name)),
                                 {{isNearest ? nearestText(*found, row, seamless) : wrapText(*found, row),
                                   coordinateInks.at(i)}}});
            if (isLinearHere(unit) && !unit.sample.lod.ellipse)
                step.rows.push_back({"", {{linearText(*found, row, seamless), coordinateInks.at(i)}}});
            const auto tie = std::ranges::find_if(unit.ties.ties, [&](const Tie& each) {
                return each.between == Tie::Between::Texels && each.level == extent.level &&
                       each.axis == axis && each.chosen == nearestTexel(found->texels, row);
            });
            if (tie != unit.ties.ties.end())
                step.rows.push_back(
                    {"",
                     {{Sentence("on the edge of {0} and {1}: either is correct",
                                texelText(tie->chosen, row, seamless), texelText(tie->other, row, seamless)),
                       coordinateInks.at(i)}}});
        }
        if (isAtCorner(unit, extent.level, extent.size.x))
            step.rows.push_back(
                {N_("Three faces meet here: the mean of their texels replaces the missing fourth.")});
    }
    if (unit.sample.probes.size() > 1)
        step.rows.push_back({Sentence("The first of {0} probes is shown.", unit.sample.probes.size())});
    return step;
}

Sentence placeText(const Tap& tap, Target target, bool severalLevels) {
    std::string indices = std::to_string(tap.index.x);
    for (int axis = 1; axis < axesOf(target); ++axis)
        indices += fmt::format(", {}", tap.index[axis]);
    const Sentence place = severalLevels ? Sentence("level {0} ({1})", tap.level, ProperName{indices})
                                         : Sentence("({0})", ProperName{indices});
    return target == Target::CubeMap ? Sentence("{0} {1}", rowOf(cubeFaceAt(tap.index.z)).label, place)
                                     : place;
}

/// Three digits are enough to distinguish colours, and leave room next to them.
std::string shorter(float value) {
    return columnText(value, 3);
}

/// "6/15" below each component of a tap.
StepRow storedRow(const StoredTexel& stored) {
    StepRow row{indented(N_("stored")), {{}}};
    for (std::size_t c = 0; c < stored.numbers.size(); ++c)
        row.cells.push_back(
            {stored.max[c] == 0 ? "-" : fmt::format("{}/{}", stored.numbers[c], stored.max[c]), Ink::Dim});
    return row;
}

/// From which bytes of the program's memory a texel was read.
void addBytes(std::vector<StepRow>& rows, const UnitExplanation& unit, const Tap& tap) {
    if (!unit.uploaded)
        return;
    if (const auto bytes = texelBytes(*unit.uploaded, unit.target, tap))
        rows.push_back({indented(sentenceOf(*bytes)), {}, {}, false, Ink::Dim});
}

/// What a texel is not as the image's file has it, and why; empty where it is.
Sentence preparedSentence(const UnitExplanation& unit) {
    std::vector<Sentence> names;
    for (const ImageOp op : unit.preparation)
        names.emplace_back(rowOf(op).label);
    return names.empty() ? Sentence()
                         : Sentence("The image was prepared: {0}.", Sentence::joined("{0}, {1}", names));
}

/// Section 3.8.14.
Step depthsStep(const UnitExplanation& unit) {
    const bool asks = compares(unit);
    const glm::vec4 color = unit.sample.color;
    // In any format, the first or the last component has the depth.
    const float result = unit.format == BaseFormat::Alpha ? color.a : color.r;
    Step step{StepKind::Texels, unit.unit, asks ? N_("Depths, compared") : N_("Depths"), {}};
    step.swatch = color;
    const std::string function(rowOf(unit.sampler.compareFunc).name);
    step.summary =
        asks ? Sentence("r {0} the depth: {1}", ProperName{function}, ProperName{numberText(result)})
             : Sentence(numberText(result));
    const float r = comparedDepth(unit.coords.p);
    const bool isClose =
        asks && std::ranges::any_of(unit.sample.taps, [&](const Tap& tap) {
            return tap.depth != r && columnText(tap.depth, depthDigits) == columnText(r, depthDigits);
        });
    const int digits = isClose ? allDigits : depthDigits;
    if (asks)
        step.rows.push_back({N_("r over q, clamped to 0 ... 1"), {{columnText(r, digits), Ink::R}}});
    StepRow head{N_("texel"), {{N_("weight"), Ink::Dim}, {N_("depth"), Ink::Dim}}, {}, true};
    if (asks)
        head.cells.push_back({function, Ink::Dim});
    step.rows.push_back(std::move(head));
    const std::vector<Tap> taps = mergedTaps(unit.sample);
    const auto depthText = [&](float depth) { return columnText(depth, digits); };
    for (std::size_t i = 0; i < std::min(taps.size(), maxTapsShown); ++i) {
        const Tap& tap = taps[i];
        const Sentence place = placeText(tap, unit.target, unit.sample.levels.size() > 1);
        StepRow row{tap.border ? Sentence("{0} border", place) : place,
                    {{columnText(tap.weight)}, {depthText(tap.depth)}},
                    tap.color};
        if (asks) {
            const bool passed = (unit.format == BaseFormat::Alpha ? tap.color.a : tap.color.r) != 0;
            row.cells.push_back({passed ? N_("1: passes") : N_("0: fails"), passed ? Ink::Good : Ink::Bad});
        }
        step.rows.push_back(std::move(row));
        addBytes(step.rows, unit, tap);
    }
    if (taps.size() > maxTapsShown)
        step.rows.push_back({Sentence("and {0} more with less weight", taps.size() - maxTapsShown)});
    if (const Sentence sentence = preparedSentence(unit); !sentence.empty())
        step.rows.push_back({sentence, {}, {}, false, Ink::Dim});
    step.rows.push_back(
        {asks ? N_("filtered: the share that passes") : N_("filtered"), {{columnText(result)}}, color});
    step.rows.push_back({Sentence("as {0}", ProperName{rowOf(unit.sampler.depthMode).name}),
                         {{fmt::format("{} {} {} {}", numberText(color.r), numberText(color.g),
                                       numberText(color.b), numberText(color.a))}},
                         color});
    return step;
}

Step texelsStep(const UnitExplanation& unit) {
    if (isDepth(unit.internalFormat))
        return depthsStep(unit);
    Step step{StepKind::Texels, unit.unit, N_("Texels"), {}};
    const glm::vec4 color = unit.sample.color;
    step.swatch = color;
    step.summary = fmt::format("{} {} {} {}", numberText(color.r), numberText(color.g), numberText(color.b),
                               numberText(color.a));
    StepRow head = componentHeading(N_("texel"));
    head.cells.insert(head.cells.begin(), {N_("weight"), Ink::Dim});
    step.rows.push_back(std::move(head));
    const std::vector<Tap> taps = mergedTaps(unit.sample);
    for (std::size_t i = 0; i < std::min(taps.size(), maxTapsShown); ++i) {
        const Tap& tap = taps[i];
        const bool across = unit.sample.seamless && tap.index.z != unit.sample.cube->face;
        const Sentence place = placeText(tap, unit.target, unit.sample.levels.size() > 1);
        StepRow row{tap.border ? Sentence("{0} border", place)
                    : across   ? Sentence("{0} across the edge", place)
                               : place,
                    {{columnText(tap.weight)}},
                    tap.color};
        for (int c = 0; c < 4; ++c)
            row.cells.push_back({shorter(tap.color[c])});
        step.rows.push_back(std::move(row));
        if (const auto stored = storedTexel(unit.internalFormat, tap.color); stored && !tap.border)
            step.rows.push_back(storedRow(*stored));
        addBytes(step.rows, unit, tap);
    }
    if (taps.size() > maxTapsShown)
        step.rows.push_back({Sentence("and {0} more with less weight", taps.size() - maxTapsShown)});
    const Sentence drawn = unit.picture == 0 ? Sentence()
                                             : Sentence("Each texel is a pixel of picture {0}, which passes "
                                                        "drew before.",
                                                        unit.picture);
    for (const Sentence& sentence : {drawn, preparedSentence(unit), storedSentence(unit.internalFormat)}) {
        if (!sentence.empty())
            step.rows.push_back({sentence, {}, {}, false, Ink::Dim});
    }
    StepRow sum{N_("filtered"), {{columnText(1)}}, color};
    for (int c = 0; c < 4; ++c)
        sum.cells.push_back({shorter(color[c])});
    step.rows.push_back(std::move(sum));
    for (const Tap& tap : unit.ties.others) {
        StepRow row{
            Sentence("also correct: {0}", placeText(tap, unit.target, true)), {{"", Ink::Dim}}, tap.color};
        for (int c = 0; c < 4; ++c)
            row.cells.push_back({shorter(tap.color[c]), Ink::Dim});
        step.rows.push_back(std::move(row));
    }
    return step;
}

} // namespace

std::vector<Step> samplingSteps(const FragmentExplanation& fragment, const UnitExplanation& unit) {
    return {coordinatesStep(fragment, unit), lodStep(unit), wrapStep(unit), texelsStep(unit)};
}

std::string lambdaText(const Lod& lod) {
    // What decides is c, or how far it is half-way between two levels.
    const bool isByFilters = std::abs(lod.lambda - lod.switchOver) < 0.25F;
    return numberText(lod.lambda, isByFilters ? lod.switchOver : std::floor(lod.lambda) + 0.5F);
}

Sentence whyMagnified(const UnitExplanation& unit) {
    const Lod& lod = unit.sample.lod;
    const ProperName mag{rowOf(unit.sampler.magFilter).name};
    const ProperName min{rowOf(unit.sampler.minFilter).name};
    const Sentence c = lod.switchOver > 0 ? Sentence("{0} (as {1} meets {2})",
                                                     ProperName{numberText(lod.switchOver)}, mag, min)
                                          : "0";
    return lod.magnified ? Sentence("lambda is not above {0}: the magnification filter decides, {1}.", c, mag)
                         : Sentence("lambda is above {0}: the minification filter decides, {1}.", c, min);
}

namespace {

std::array<int, 4> texelOf(const Tap& tap) {
    return {tap.level, tap.index.z, tap.index.y, tap.index.x};
}

} // namespace

std::vector<Tap> mergedTaps(const SampleRecord& sample) {
    if (sample.taps.size() <= fewTaps)
        return sample.taps;
    std::vector<Tap> taps = sample.taps;
    std::ranges::stable_sort(taps, {}, texelOf);
    std::vector<Tap> merged;
    for (const Tap& tap : taps) {
        if (!merged.empty() && texelOf(merged.back()) == texelOf(tap))
            merged.back().weight += tap.weight;
        else
            merged.push_back(tap);
    }
    std::ranges::stable_sort(merged, std::ranges::greater(), &Tap::weight);
    return merged;
}

std::size_t texelCount(const SampleRecord& sample) {
    std::vector<std::array<int, 4>> texels;
    std::ranges::transform(sample.taps, std::back_inserter(texels), texelOf);
    std::ranges::sort(texels);
    return static_cast<std::size_t>(std::ranges::unique(texels).begin() - texels.begin());
}

} // namespace texplorer::reference
