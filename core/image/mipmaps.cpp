#include "texplorer/image/mipmaps.h"

#include "texplorer/image/alpha_coverage.h"
#include "texplorer/image/linear_light.h"
#include "texplorer/image/mip_colors.h"
#include "texplorer/image/resample.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace texplorer {

namespace {

int half(int extent) {
    return std::max(1, extent / 2);
}

// Which texels of a line of `extent` make texel `index` of the next level, and how much of each.
//
//   even, 4 -> 2:  | 0 | 1 | 2 | 3 |       odd, 5 -> 2:  | 0 | 1 | 2 | 3 | 4 |
//                  |   0   |   1   |                     |    0    |    1    |
//   weights           1 1     1 1                           2 2 1     1 2 2
//
// The weights are whole numbers with the sum `Axis::total`, so that all sums are exact.
struct Taps {
    int first;
    int count;
    std::array<std::uint64_t, 3> weights;
};

struct Axis {
    int extent;
    std::uint64_t total;

    explicit Axis(int texels)
        : extent(texels)
        , total(texels == 1       ? 1
                : texels % 2 == 0 ? 2
                                  : static_cast<std::uint64_t>(texels)) {}

    [[nodiscard]] Taps taps(int index) const {
        if (extent == 1)
            return {0, 1, {1, 0, 0}};
        if (extent % 2 == 0)
            return {2 * index, 2, {1, 1, 0}};
        const auto before = static_cast<std::uint64_t>(half(extent) - index);
        const auto after = static_cast<std::uint64_t>(index) + 1;
        return {2 * index, 3, {before, static_cast<std::uint64_t>(half(extent)), after}};
    }
};

// What is added up: the stored values, or the light that they stand for. Alpha is no light: it is widened to
// the same 16 bits.
struct StoredValues {
    explicit StoredValues(PixelFormat /*format*/) {}
    [[nodiscard]] std::uint64_t expand(std::byte value, std::size_t /*index*/) const {
        return std::to_integer<std::uint64_t>(value);
    }
    [[nodiscard]] std::byte reduce(std::uint64_t value, std::size_t /*component*/) const {
        return static_cast<std::byte>(value);
    }
};

struct LightValues {
    explicit LightValues(PixelFormat format)
        : components(static_cast<std::size_t>(bytesPerPixel(format)))
        , alpha(alphaComponent(format) < 0 ? components : static_cast<std::size_t>(alphaComponent(format))) {}

    [[nodiscard]] std::uint64_t expand(std::byte value, std::size_t index) const {
        const auto stored = std::to_integer<std::size_t>(value);
        return index % components == alpha ? stored * 257 : table.light[stored];
    }
    [[nodiscard]] std::byte reduce(std::uint64_t value, std::size_t component) const {
        return static_cast<std::byte>(component == alpha ? (value + 128) / 257
                                                         : table.stored[static_cast<std::size_t>(value)]);
    }

    std::size_t components;
    std::size_t alpha;
    const LinearLight& table = LinearLight::table();
};

// Adds the rows that make one row of the next level, weighted, into `sums`.
template<class Values>
void gatherRows(const Image& from, const Taps& rows, const Taps& slices, const Values& values,
                std::vector<std::uint64_t>& sums) {
    std::ranges::fill(sums, 0U);
    for (int z = 0; z < slices.count; ++z)
        for (int y = 0; y < rows.count; ++y) {
            const std::uint64_t weight =
                slices.weights[static_cast<std::size_t>(z)] * rows.weights[static_cast<std::size_t>(y)];
            const std::byte* row = from.pixels.data() + from.offset(0, rows.first + y, slices.first + z);
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] += weight * values.expand(row[i], i);
        }
}

// Any size, any format. The largest sum, 65535 * 16384^3, stays below 2^58.
template<class Values>
Image averageByCoverage(const Image& from) {
    Image to = Image::uninitialised(from.format, half(from.width), half(from.height), half(from.depth));
    const Axis axisX(from.width);
    const Axis axisY(from.height);
    const Axis axisZ(from.depth);
    const std::uint64_t total = axisX.total * axisY.total * axisZ.total;
    const auto components = static_cast<std::size_t>(bytesPerPixel(from.format));
    const Values values(from.format);

    std::vector<std::uint64_t> sums(from.rowBytes());
    std::byte* out = to.pixels.data();
    for (int z = 0; z < to.depth; ++z)
        for (int y = 0; y < to.height; ++y) {
            gatherRows(from, axisY.taps(y), axisZ.taps(z), values, sums);
            for (int x = 0; x < to.width; ++x) {
                const Taps columns = axisX.taps(x);
                const std::uint64_t* texel =
                    sums.data() + static_cast<std::size_t>(columns.first) * components;
                for (std::size_t c = 0; c < components; ++c) {
                    std::uint64_t sum = total / 2;
                    for (std::size_t i = 0; i < static_cast<std::size_t>(columns.count); ++i)
                        sum += columns.weights[i] * texel[i * components + c];
                    *out++ = values.reduce(sum / total, c);
                }
            }
        }
    return to;
}

// Four RGBA texels at once: red and blue are added in one word, green and alpha in the other, 16 bits of room
// each.
std::uint32_t averageOfFour(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t odd = 0x00FF00FFU;
    constexpr std::uint32_t two = 0x00020002U;
    const std::uint32_t low = (a & odd) + (b & odd) + (c & odd) + (d & odd) + two;
    const std::uint32_t high =
        ((a >> 8) & odd) + ((b >> 8) & odd) + ((c >> 8) & odd) + ((d >> 8) & odd) + two;
    return ((low >> 2) & odd) | (((high >> 2) & odd) << 8);
}

std::uint32_t texelAt(const std::byte* row, std::size_t x) {
    std::uint32_t texel = 0;
    std::memcpy(&texel, row + 4 * x, sizeof texel);
    return texel;
}

// Counted by an index and read texel by texel, so that the compiler vectorises it.
void averageRowsOfRgba(const std::byte* lower, const std::byte* upper, std::size_t count, std::byte* out) {
    for (std::size_t x = 0; x < count; ++x) {
        const std::uint32_t mean = averageOfFour(texelAt(lower, 2 * x), texelAt(lower, 2 * x + 1),
                                                 texelAt(upper, 2 * x), texelAt(upper, 2 * x + 1));
        std::memcpy(out + 4 * x, &mean, sizeof mean);
    }
}

template<std::size_t Components>
void averageRowsOf(const std::byte* lower, const std::byte* upper, std::size_t count, std::byte* out) {
    for (std::size_t x = 0; x < count; ++x) {
        for (std::size_t c = 0; c < Components; ++c) {
            const std::size_t left = 2 * x * Components + c;
            const auto pair = [&](const std::byte* row) {
                return std::to_integer<unsigned>(row[left]) +
                       std::to_integer<unsigned>(row[left + Components]);
            };
            out[x * Components + c] = static_cast<std::byte>((pair(lower) + pair(upper) + 2) >> 2);
        }
    }
}

/// Of a format with a byte for each component.
Image averageEven(const Image& from) {
    constexpr std::array averages{averageRowsOf<1>, averageRowsOf<2>, averageRowsOf<3>, averageRowsOfRgba};
    const auto average = averages.at(static_cast<std::size_t>(bytesPerPixel(from.format)) - 1);
    Image to = Image::uninitialised(from.format, from.width / 2, from.height / 2);
    const std::size_t stride = from.rowBytes();
    for (int y = 0; y < to.height; ++y) {
        const std::byte* row = from.pixels.data() + from.offset(0, 2 * y, 0);
        average(row, row + stride, static_cast<std::size_t>(to.width), to.pixels.data() + to.offset(0, y, 0));
    }
    return to;
}

Image nextLevel(const Image& from, const MipOptions& options) {
    if (from.format == PixelFormat::RgbaFloat) // whose levels a driver or GLU makes
        return scaleByCoverage(from, half(from.width), half(from.height), half(from.depth));
    if (options.filter != MipFilter::Box && from.depth == 1)
        return scaleFiltered(from, half(from.width), half(from.height), options.filter, options.linearLight);
    if (options.linearLight)
        return averageByCoverage<LightValues>(from);
    const bool even = from.width % 2 == 0 && from.height % 2 == 0 && from.depth == 1;
    return even && from.format != PixelFormat::Depth32 ? averageEven(from)
                                                       : averageByCoverage<StoredValues>(from);
}

Image flatLevel(const Image& above, int level) {
    Image flat =
        Image::uninitialised(PixelFormat::Rgba8, half(above.width), half(above.height), half(above.depth));
    const auto color = mipColor(level);
    for (std::size_t i = 0; i < flat.pixels.size(); ++i)
        flat.pixels[i] = std::byte{color[i % color.size()]};
    return flat;
}

Image scaledBase(Image base, const MipOptions& options) {
    return options.npot == NpotPolicy::PowerOfTwo ? toPowerOfTwo(std::move(base)) : std::move(base);
}

template<class MakeLevel>
MipChain levelsAbove(const Image& base, MakeLevel makeLevel) {
    MipChain levels;
    const int count = base.empty() ? 0 : mipLevelCount(base.width, base.height, base.depth);
    for (int level = 1; level < count; ++level)
        levels.push_back(makeLevel(levels.empty() ? base : levels.back(), level));
    return levels;
}

/// Each level for itself, after it was made of those that are not scaled.
MipChain withCoverageOf(const Image& base, MipChain levels, float reference) {
    if (reference <= 0 || alphaComponent(base.format) < 0)
        return levels;
    const double coverage = alphaCoverage(base, reference);
    for (Image& level : levels)
        level = withCoverage(std::move(level), reference, coverage);
    return levels;
}

} // namespace

int mipLevelCount(int width, int height, int depth) {
    const auto [smallest, largest] = std::minmax({width, height, depth});
    return smallest < 1 ? 0 : static_cast<int>(std::bit_width(static_cast<unsigned>(largest)));
}

MipChain mipLevelsAbove(MipPolicy policy, const Image& base, const MipOptions& options) {
    switch (policy) {
    case MipPolicy::Generated:
    case MipPolicy::Missing:
    case MipPolicy::GenerateMipmap:
    case MipPolicy::OnUpload:
    case MipPolicy::Glu:
        return withCoverageOf(
            base, levelsAbove(base, [&](const Image& above, int) { return nextLevel(above, options); }),
            options.coverage);
    case MipPolicy::Colored:
        return levelsAbove(base, flatLevel);
    case MipPolicy::None:
    case MipPolicy::FromFile:
    case MipPolicy::Given:
        break;
    }
    return {};
}

MipChain applyMipPolicy(MipPolicy policy, Image base, const MipOptions& options) {
    if (base.empty())
        return {};
    base = scaledBase(std::move(base), options);
    MipChain levels = mipLevelsAbove(policy, base, options);
    levels.insert(levels.begin(), std::move(base));
    return levels;
}

MipChain buildMipChain(Image base, const MipOptions& options) {
    return applyMipPolicy(MipPolicy::Generated, std::move(base), options);
}

} // namespace texplorer
