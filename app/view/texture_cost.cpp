#include "app/view/texture_cost.h"

#include <fmt/core.h>

namespace texplorer::view {
namespace {

/// Three digits.
std::string digits(double value) {
    return fmt::format("{:.{}f}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

} // namespace

Texture textureOf(const CostVariant& variant) {
    Texture texture;
    texture.compression = variant.compression;
    texture.compressedFormat = CompressedFormat::Dxt1;
    texture.compressionQuality = EncodeQuality::Fast;
    texture.mipmaps = variant.mipmaps;
    texture.minFilter = variant.minFilter;
    texture.magFilter = variant.magFilter;
    texture.maxAnisotropy = variant.anisotropy;
    return texture;
}

double progressOf(const TextureCosts& costs, std::size_t pairs) {
    double done = 0;
    for (const CostTimes& row : costs)
        done += row.lack.empty() ? static_cast<double>(row.times.b.size()) / static_cast<double>(pairs) : 1;
    return done / static_cast<double>(costs.size());
}

Sentence timeText(double seconds) {
    if (seconds < 0.9995e-3)
        return {N_("{0} µs"), ProperName{digits(seconds * 1e6)}};
    return {N_("{0} ms"), ProperName{digits(seconds * 1e3)}};
}

Sentence verdictOn(const CostTimes& row) {
    const TimeComparison compared = compareTimes(row.times);
    if (!row.lack.empty() || compared.pairs == 0)
        return row.lack;
    if (compared.pairs < minTimePairs)
        return Sentence::plural("{0} pair: at least {1} are needed", "{0} pairs: at least {1} are needed",
                                compared.pairs, minTimePairs);
    const std::array numbers{digits(compared.ratio.median), digits(compared.ratio.low),
                             digits(compared.ratio.high)};
    const std::array names{ProperName{numbers[0]}, ProperName{numbers[1]}, ProperName{numbers[2]}};
    return compared.differs ? Sentence("B takes {0}× ({1}–{2}×) the time of A", names[0], names[1], names[2])
                            : Sentence("no difference shown: {0}× ({1}–{2}×)", names[0], names[1], names[2]);
}

std::vector<Sentence> costLimits(std::string_view renderer) {
    constexpr std::array onProcessor{"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software Rasterizer"};
    std::vector<Sentence> limits;
    const auto software = std::ranges::find_if(
        onProcessor, [renderer](const char* name) { return renderer.find(name) != std::string_view::npos; });
    if (software != onProcessor.end())
        limits.push_back(
            Sentence("{0} draws on the processor: textures stay in the program's memory, and an upload is a "
                     "copy. A graphics card may differ in every row.",
                     ProperName{*software}));
    else
        limits.emplace_back(N_("Only this driver was measured; another one may differ in every row."));
    limits.emplace_back(
        N_("glFinish ends each sample of about 2 ms, whose mean is shown. A program does not wait like "
           "this: uploads can overlap with drawing."));
    limits.emplace_back(
        N_("A single texture stays in the caches. In a program many textures compete for them, which is "
           "where small and compressed ones gain."));
    limits.emplace_back(
        N_("Other work of the computer is in the samples, and so are changes of its clock rate."));
    return limits;
}

} // namespace texplorer::view
