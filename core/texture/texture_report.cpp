// The numbers of TextureReport: what a texture costs, and what its compression lost.

#include "core/image/convert.h"
#include "core/image/linear_light.h"
#include "core/s3tc/decode.h"
#include "core/texture/texture_levels.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer {

namespace {

/// How many of red, green, blue and alpha a format keeps.
std::size_t componentsOf(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
        return 3;
    case BlockFormat::Bc4:
    case BlockFormat::Bc4Signed:
        return 1;
    case BlockFormat::Bc5:
    case BlockFormat::Bc5Signed:
        return 2;
    default:
        return 4;
    }
}

/// Over the components that the compressed format keeps: RGB formats have no alpha to lose.
std::optional<double> psnrOf(const Surface& surface, const Image& source) {
    if (widthOf(surface) != source.width || heightOf(surface) != source.height ||
        depthOf(surface) != source.depth || source.empty())
        return std::nullopt;
    const auto* blocks = std::get_if<BlockImage>(&surface);
    const Image decoded = blocks ? decodeBlocks(*blocks) : Image{};
    const Image& found = blocks ? decoded : std::get<Image>(surface);
    const std::size_t components =
        blocks ? componentsOf(blocks->format) : (alphaComponent(found.format) >= 0 ? 4 : 3);

    const auto foundStep = static_cast<std::size_t>(bytesPerPixel(found.format));
    const auto sourceStep = static_cast<std::size_t>(bytesPerPixel(source.format));
    const std::size_t texels = source.pixels.size() / sourceStep;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < texels; ++i) {
        const auto a = rgbaOf(found.format, found.pixels.data() + i * foundStep);
        const auto b = rgbaOf(source.format, source.pixels.data() + i * sourceStep);
        for (std::size_t c = 0; c < components; ++c)
            sum += static_cast<std::uint64_t>((a[c] - b[c]) * (a[c] - b[c]));
    }
    if (sum == 0)
        return std::numeric_limits<double>::infinity();
    const double mean = static_cast<double>(sum) / static_cast<double>(texels * components);
    return 10 * std::log10(255.0 * 255.0 / mean);
}

std::string psnrText(const std::optional<double>& psnr) {
    if (!psnr)
        return {};
    if (std::isinf(*psnr))
        return "  exact";
    return fmt::format("  {:.1f} dB", *psnr);
}

} // namespace

TextureReport reportOn(const TextureLevels& levels) {
    TextureReport report = reportOn(levels.levels, levels.source);
    const bool areBlocks =
        !levels.levels.empty() && std::holds_alternative<BlockImage>(*levels.levels.front().surface);
    if (areBlocks || report.levels.empty())
        return report;
    // The levels are still pixels: what will become of them is known.
    const std::size_t before = report.bytes;
    report.bytes = 0;
    for (LevelReport& level : report.levels) {
        const auto extent = [&](int texels) {
            return levels.driverFormat ? (static_cast<std::size_t>(texels) + 3) / 4
                                       : static_cast<std::size_t>(texels);
        };
        const std::size_t unit = levels.driverFormat
                                     ? bytesPerBlock(*levels.driverFormat)
                                     : static_cast<std::size_t>(bytesPerTexel(levels.internalFormat));
        level.bytes = extent(level.width) * extent(level.height) * static_cast<std::size_t>(level.depth) *
                      static_cast<std::size_t>(level.faces) * unit;
        report.bytes += level.bytes;
    }
    if (before == 0)
        return report;
    const double change = static_cast<double>(report.bytes) / static_cast<double>(before);
    report.ratioToBase = static_cast<double>(report.bytes) / static_cast<double>(report.levels.front().bytes);
    report.shareOfRgba8 *= change;
    report.shareOfRgb8 *= change;
    return report;
}

TextureReport reportOn(const std::vector<TextureLevel>& levels, const MipChain& source) {
    TextureReport report;
    double texels = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const Surface& surface = levels[i].surface;
        const auto known = std::ranges::find(report.levels, levels[i].number, &LevelReport::number);
        const bool isNew = known == report.levels.end();
        LevelReport& level = isNew ? report.levels.emplace_back() : *known;
        level.number = levels[i].number;
        level.width = widthOf(surface);
        level.height = heightOf(surface);
        level.depth = depthOf(surface);
        level.faces += isNew ? 0 : 1;
        level.bytes += byteCount(surface);
        if (const auto psnr = i < source.size() ? psnrOf(surface, source[i]) : std::nullopt; psnr)
            level.psnr = std::min(level.psnr.value_or(*psnr), *psnr);
        report.bytes += byteCount(surface);
        texels += static_cast<double>(level.width) * level.height * level.depth;
    }
    if (report.bytes == 0)
        return report;
    report.ratioToBase = static_cast<double>(report.bytes) / static_cast<double>(report.levels.front().bytes);
    report.shareOfRgba8 = static_cast<double>(report.bytes) / (4 * texels);
    report.shareOfRgb8 = static_cast<double>(report.bytes) / (3 * texels);
    return report;
}

std::string describe(const TextureReport& report) {
    std::string text;
    for (const LevelReport& level : report.levels) {
        std::string extents = fmt::format("{} x {}", level.width, level.height);
        if (level.depth > 1)
            extents += fmt::format(" x {}", level.depth);
        if (level.faces > 1)
            extents += fmt::format(", {} faces", level.faces);
        text += fmt::format("level {:2}  {:16} {:10} bytes{}\n", level.number, extents, level.bytes,
                            psnrText(level.psnr));
    }
    return fmt::format("{}sum {:33} bytes, {:.3f} times the base; {:.1f} % of RGBA8, {:.1f} % of RGB8\n",
                       text, report.bytes, report.ratioToBase, 100 * report.shareOfRgba8,
                       100 * report.shareOfRgb8);
}

} // namespace texplorer
