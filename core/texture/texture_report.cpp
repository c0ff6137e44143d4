// The numbers of TextureReport: what a texture costs, and what its compression lost.

#include "texplorer/image/convert.h"
#include "texplorer/image/linear_light.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/texture/texture_levels.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace texplorer {

namespace {

/// Which of red, green, blue and alpha are compared.
struct ComparedParts {
    std::size_t first = 0;
    std::size_t count = 4;
};

/// Those that the format keeps and the picture has: RGB formats have no alpha to lose, nor has an opaque
/// picture that stays one; a picture of alpha alone has no colours.
ComparedParts comparedIn(const Surface& surface, const Image& source, bool bothOpaque) {
    const auto* blocks = std::get_if<BlockImage>(&surface);
    const std::size_t kept =
        blocks ? keptComponents(blocks->format)
               : (alphaComponent(std::get<Image>(surface).format) >= 0 ? std::size_t{4} : std::size_t{3});
    if (kept == 4 && source.format == PixelFormat::Alpha8)
        return {3, 1};
    return {0, bothOpaque ? std::min<std::size_t>(kept, 3) : kept};
}

struct Quality {
    double psnr;
    std::string_view components; ///< "RGB"
};

std::optional<Quality> qualityOf(const Surface& surface, const Image& source) {
    if (widthOf(surface) != source.width || heightOf(surface) != source.height ||
        depthOf(surface) != source.depth || source.empty())
        return std::nullopt;
    const auto* blocks = std::get_if<BlockImage>(&surface);
    const Image decoded = blocks ? decodeBlocks(*blocks) : Image{};
    const Image& found = blocks ? decoded : std::get<Image>(surface);

    const auto foundStep = static_cast<std::size_t>(bytesPerPixel(found.format));
    const auto sourceStep = static_cast<std::size_t>(bytesPerPixel(source.format));
    const std::size_t texels = source.pixels.size() / sourceStep;
    std::array<std::uint64_t, 4> squares{};
    bool bothOpaque = true;
    for (std::size_t i = 0; i < texels; ++i) {
        const auto a = rgbaOf(found.format, found.pixels.data() + i * foundStep);
        const auto b = rgbaOf(source.format, source.pixels.data() + i * sourceStep);
        for (std::size_t c = 0; c < squares.size(); ++c)
            squares[c] += static_cast<std::uint64_t>((a[c] - b[c]) * (a[c] - b[c]));
        bothOpaque = bothOpaque && a[3] == 255 && b[3] == 255;
    }
    const ComparedParts compared = comparedIn(surface, source, bothOpaque);
    const auto first = squares.begin() + static_cast<std::ptrdiff_t>(compared.first);
    const std::uint64_t sum =
        std::accumulate(first, first + static_cast<std::ptrdiff_t>(compared.count), std::uint64_t{0});
    constexpr std::string_view names = "RGBA";
    const std::string_view components = names.substr(compared.first, compared.count);
    if (sum == 0)
        return Quality{std::numeric_limits<double>::infinity(), components};
    const double mean = static_cast<double>(sum) / static_cast<double>(texels * compared.count);
    return Quality{10 * std::log10(255.0 * 255.0 / mean), components};
}

/// "  41.9 dB in RGB"
std::string psnrText(const LevelReport& level) {
    if (!level.psnr)
        return {};
    return std::isinf(*level.psnr) ? fmt::format("  exact in {}", level.components)
                                   : fmt::format("  {:.1f} dB in {}", *level.psnr, level.components);
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
        const auto quality = i < source.size() ? qualityOf(surface, source[i]) : std::nullopt;
        if (quality && (!level.psnr || quality->psnr < *level.psnr)) {
            level.psnr = quality->psnr;
            level.components = quality->components;
        }
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
        std::string extents = fmt::format("{} × {}", level.width, level.height);
        if (level.depth > 1)
            extents += fmt::format(" × {}", level.depth);
        if (level.faces > 1)
            extents += fmt::format(", {} faces", level.faces);
        text += fmt::format("level {:2}  {:16} {:10} bytes{}\n", level.number, extents, level.bytes,
                            psnrText(level));
    }
    return fmt::format("{}sum {:33} bytes, {:.3f} times the base; {:.1f} % of RGBA8, {:.1f} % of RGB8\n",
                       text, report.bytes, report.ratioToBase, 100 * report.shareOfRgba8,
                       100 * report.shareOfRgb8);
}

} // namespace texplorer
