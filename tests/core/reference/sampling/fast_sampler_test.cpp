// Every kernel's sampler against the literal one: the same bits, everywhere.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/raster/kernel.h"
#include "texplorer/reference/sampling/lanes.h"
#include "texplorer/reference/sampling/sampler.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace texplorer::reference::fast_sampler_test {
namespace {

using namespace test;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Every texel of every level has its own colour.
SampledTexture texture(Target target, glm::ivec3 size) {
    SampledTexture made;
    made.target = target;
    for (int level = 0;; ++level) {
        made.levels.push_back(makeLevel(
            size,
            [level](int i, int j, int k) {
                return glm::vec4((i * 37 + j * 11 + level * 5) % 256, (i * 3 + j * 59 + k * 17) % 256,
                                 (level * 31 + i) % 256, (i + j) % 256) /
                       255.0F;
            },
            0, axesOf(target)));
        if (size == glm::ivec3(1))
            return made;
        size = glm::max(size / 2, 1);
    }
}

/// Numbers of every magnitude, and what is no number.
class Numbers {
public:
    float coordinate() {
        switch (pick(12)) {
        case 0:
            return static_cast<float>(pick(9) - 4) / 4; // on a rim, in the middle
        case 1:
            return uniform(-1e4F, 1e4F);
        case 2:
            return anything();
        case 3:
            return static_cast<float>(pick(65)) / 64; // where texels meet
        case 4:
            return static_cast<float>(2 * pick(64) + 1) / 128; // the centres of texels
        default:
            return uniform(-3, 3);
        }
    }
    float derivative() {
        switch (pick(12)) {
        case 0:
            return 0;
        case 1:
            return anything();
        case 3:
            return std::ldexp(uniform(-1, 1), pick(278) - 149); // squares that no float holds
        case 2:
            return std::ldexp(pick(2) == 0 ? 1.0F : -1.0F, pick(12) - 10); // lambda is whole
        default:
            return std::ldexp(uniform(-1, 1), pick(14) - 10);
        }
    }

private:
    int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    float uniform(float low, float high) {
        return low + (high - low) * static_cast<float>(random_() & 0xFFFFFF) / 0x1p24F;
    }
    float anything() {
        constexpr std::array odd{0.0F,   -0.0F,  nan,        infinity,     -infinity,    1e38F,
                                 -3e38F, 1e-40F, 8388607.5F, -16777215.0F, 4294967296.0F};
        return odd[static_cast<std::size_t>(pick(static_cast<int>(odd.size())))];
    }
    std::mt19937 random_{20261121};
};

SampleRow randomRow(Numbers& numbers) {
    SampleRow row{};
    // Neighbours of a picture are alike; those that aren't must not disturb each other, either.
    const float s = numbers.coordinate();
    const float t = numbers.coordinate();
    const float dsdx = numbers.derivative();
    const float dtdy = numbers.derivative();
    for (std::size_t i = 0; i < SampleRow::capacity; ++i) {
        const bool alike = i < SampleRow::capacity / 2;
        row.s[i] = alike ? s + dsdx * static_cast<float>(i) : numbers.coordinate();
        row.t[i] = alike ? t : numbers.coordinate();
        row.r[i] = numbers.coordinate();
        row.dsdx[i] = alike ? dsdx * (1 + static_cast<float>(i) / 16) : numbers.derivative();
        row.dtdx[i] = alike ? 0 : numbers.derivative();
        row.drdx[i] = numbers.derivative();
        row.dsdy[i] = alike ? 0 : numbers.derivative();
        row.dtdy[i] = alike ? dtdy : numbers.derivative();
        row.drdy[i] = numbers.derivative();
    }
    return row;
}

void expectTheSame(const Kernel& kernel, const SampledTexture& texture, const SampleOptions& options,
                   const SampleRow& row) {
    SCOPED_TRACE(kernel.lanes);
    std::array<glm::vec4, SampleRow::capacity> colors{};
    kernel.sample(FastSampler(texture, options), row, SampleRow::capacity, colors.data());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::vec3 at(row.s[i], row.t[i], row.r[i]);
        const Derivatives moving{{row.dsdx[i], row.dtdx[i], row.drdx[i]},
                                 {row.dsdy[i], row.dtdy[i], row.drdy[i]}};
        const glm::vec4 literal = sample(texture, at, moving, options);
        ASSERT_EQ(colors[i], literal)
            << "place " << i << " at " << at.s << ", " << at.t << ", moving by " << moving.dx.s << ", "
            << moving.dx.t << " and " << moving.dy.s << ", " << moving.dy.t << "; found " << colors[i].r
            << " " << colors[i].g << " " << colors[i].b << " " << colors[i].a << ", not " << literal.r << " "
            << literal.g << " " << literal.b << " " << literal.a;
    }
}

void expectTheSame(const SampledTexture& texture, const SampleOptions& options, const SampleRow& row) {
    for (const Kernel* kernel : kernels())
        expectTheSame(*kernel, texture, options, row);
}

struct Shape {
    const char* name;
    Target target;
    glm::ivec3 size;
};

class FastSamplerTest
    : public testing::TestWithParam<std::tuple<Shape, MinFilter, MagFilter, AnisotropyMethod, float>> {};

// Every pair of wrap modes in turn.
TEST_P(FastSamplerTest, EqualsTheLiteralOne) {
    const auto& [shape, min, mag, method, anisotropy] = GetParam();
    SampledTexture made = texture(shape.target, shape.size);
    made.minFilter = min;
    made.magFilter = mag;
    made.maxAnisotropy = anisotropy;
    made.borderColor = {1, 0.5F, 0.25F, 0.125F};
    Numbers numbers;
    for (const EnumRow& s : wrapRows) {
        for (const EnumRow& t : wrapRows) {
            SCOPED_TRACE(std::string(s.name) + " " + std::string(t.name));
            made.wrapS = made.wrapR = static_cast<Wrap>(s.value);
            made.wrapT = static_cast<Wrap>(t.value);
            for (const EnumRow& rho : rhoMethodRows)
                expectTheSame(made, {.anisotropy = method, .rho = static_cast<RhoMethod>(rho.value)},
                              randomRow(numbers));
            if (HasFatalFailure())
                return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, FastSamplerTest,
    testing::Combine(testing::Values(Shape{"Square", Target::Texture2D, {64, 64, 1}},
                                     Shape{"Odd", Target::Texture2D, {19, 5, 1}},
                                     Shape{"Line", Target::Texture1D, {64, 1, 1}},
                                     Shape{"OneTexel", Target::Texture2D, {1, 1, 1}},
                                     Shape{"Volume", Target::Texture3D, {8, 8, 8}}),
                     testing::Values(MinFilter::Nearest, MinFilter::Linear, MinFilter::NearestMipmapNearest,
                                     MinFilter::LinearMipmapNearest, MinFilter::NearestMipmapLinear,
                                     MinFilter::LinearMipmapLinear),
                     testing::Values(MagFilter::Nearest, MagFilter::Linear),
                     testing::Values(AnisotropyMethod::Probes, AnisotropyMethod::Ellipse,
                                     AnisotropyMethod::Line),
                     testing::Values(1.0F, 2.5F, 16.0F)),
    [](const auto& test) {
        return std::string(std::get<0>(test.param).name) + "_" + std::to_string(test.index);
    });

TEST(FastSampler, ReadsTheBytesOfTexelsLikeTheTexels) {
    Numbers numbers;
    for (const glm::ivec3 size : {glm::ivec3(64, 64, 1), glm::ivec3(19, 5, 1), glm::ivec3(1)}) {
        SampledTexture made = texture(Target::Texture2D, size);
        made.minFilter = MinFilter::Linear;
        made.levels[0].bytes = bytesOf(made.levels[0].texels);
        ASSERT_EQ(made.levels[0].bytes.size(), made.levels[0].texels.size());
        EXPECT_EQ(FastSampler(made, {}).planes[0].bytes, made.levels[0].bytes.data());
        for (const EnumRow& s : wrapRows) {
            for (const EnumRow& t : wrapRows) {
                SCOPED_TRACE(std::string(s.name) + " " + std::string(t.name));
                made.wrapS = static_cast<Wrap>(s.value);
                made.wrapT = static_cast<Wrap>(t.value);
                for (int i = 0; i < 8; ++i)
                    expectTheSame(made, {}, randomRow(numbers));
            }
        }
    }
}

// What changes lambda, and which levels there are.
struct Parameters {
    const char* name;
    void (*change)(SampledTexture&, SampleOptions&);
};
class FastSamplerParameter : public testing::TestWithParam<Parameters> {};

TEST_P(FastSamplerParameter, HasTheSameEffect) {
    Numbers numbers;
    for (const MinFilter min : {MinFilter::NearestMipmapNearest, MinFilter::LinearMipmapLinear}) {
        for (const float anisotropy : {1.0F, 4.0F}) {
            SampledTexture made = texture(Target::Texture2D, {64, 32, 1});
            made.minFilter = min;
            made.maxAnisotropy = anisotropy;
            SampleOptions options;
            GetParam().change(made, options);
            for (int i = 0; i < 8; ++i)
                expectTheSame(made, options, randomRow(numbers));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, FastSamplerParameter,
    testing::Values(
        Parameters{"Bias", [](SampledTexture&, SampleOptions& it) { it.unitBias = 1.7F; }},
        Parameters{"HugeBias", [](SampledTexture&, SampleOptions& it) { it.unitBias = -1e30F; }},
        Parameters{"BiasOfTheTexture", [](SampledTexture& it, SampleOptions&) { it.lodBias = -1.3F; }},
        Parameters{"BothBiases",
                   [](SampledTexture& texture, SampleOptions& options) {
                       texture.lodBias = 2.3F;
                       options.unitBias = -1.1F;
                   }},
        Parameters{"BothBiasesBeyondTheLimit",
                   [](SampledTexture& texture, SampleOptions& options) {
                       texture.lodBias = options.unitBias = 1.5F;
                       options.maxBias = 2;
                   }},
        Parameters{"NanBias", [](SampledTexture& it, SampleOptions&) { it.lodBias = nan; }},
        Parameters{"HugeBiasWithoutLimit",
                   [](SampledTexture&, SampleOptions& it) {
                       it.unitBias = 100;
                       it.maxBias = 1000;
                   }},
        Parameters{"HalfWay", [](SampledTexture& it, SampleOptions&) { it.minLod = 1.5F; }},
        Parameters{"JustBeforeHalfWay", [](SampledTexture& it, SampleOptions&) { it.minLod = 1.4999999F; }},
        Parameters{"JustAfterHalfWay", [](SampledTexture& it, SampleOptions&) { it.minLod = 1.5000001F; }},
        Parameters{"JustAfterTheFirstHalf",
                   [](SampledTexture& it, SampleOptions&) { it.minLod = 0.50000006F; }},
        Parameters{"MinLod", [](SampledTexture& it, SampleOptions&) { it.minLod = 1.25F; }},
        Parameters{"MaxLod", [](SampledTexture& it, SampleOptions&) { it.maxLod = 2.5F; }},
        Parameters{"NanLod", [](SampledTexture& it, SampleOptions&) { it.minLod = it.maxLod = nan; }},
        Parameters{"InfiniteLod",
                   [](SampledTexture& it, SampleOptions&) {
                       it.minLod = infinity;
                       it.maxLod = infinity;
                   }},
        Parameters{"ContradictingLod",
                   [](SampledTexture& it, SampleOptions&) {
                       it.minLod = 3;
                       it.maxLod = 1;
                   }},
        Parameters{"BaseLevel", [](SampledTexture& it, SampleOptions&) { it.baseLevel = 2; }},
        Parameters{"MaxLevel", [](SampledTexture& it, SampleOptions&) { it.maxLevel = 2; }},
        Parameters{"NoLevel", [](SampledTexture& it, SampleOptions&) { it.baseLevel = 50; }},
        Parameters{"NegativeLevel", [](SampledTexture& it, SampleOptions&) { it.baseLevel = -1; }},
        Parameters{"NoLevels", [](SampledTexture& it, SampleOptions&) { it.levels.clear(); }},
        Parameters{"AMissingLevel", [](SampledTexture& it, SampleOptions&) { it.levels[2] = {}; }},
        Parameters{"NanAnisotropy", [](SampledTexture& it, SampleOptions&) { it.maxAnisotropy = nan; }},
        Parameters{"EndlessAnisotropy",
                   [](SampledTexture& it, SampleOptions&) { it.maxAnisotropy = infinity; }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FastSampler, LeavesCubeMapsAndBordersToTheLiteralOne) {
    Numbers numbers;
    SampledTexture cube = texture(Target::Texture2D, {16, 16, 1});
    cube.target = Target::CubeMap;
    cube.otherFaces.assign(5, cube.levels);
    cube.otherFaces[2][0].texels[7] = glm::vec4(0.5F);
    SampledTexture bordered = texture(Target::Texture2D, {16, 16, 1});
    for (Level& level : bordered.levels)
        level = makeLevel(
            level.size(), [](int i, int j, int) { return glm::vec4(i + 1, j + 1, 3, 9) / 18.0F; }, 1, 2);
    bordered.wrapS = bordered.wrapT = bordered.wrapR = Wrap::Clamp;
    for (int i = 0; i < 20; ++i) {
        const SampleRow row = randomRow(numbers);
        expectTheSame(cube, {}, row);
        SampleOptions seamless;
        seamless.seamlessCubeMap = true;
        expectTheSame(cube, seamless, row);
        expectTheSame(bordered, {}, row);
    }
}

TEST(FastSampler, WritesNoMoreThanTheLastVector) {
    SampledTexture made = texture(Target::Texture2D, {8, 8, 1});
    made.minFilter = MinFilter::Linear;
    const SampleRow row{};
    const FastSampler sampler(made, {});
    EXPECT_FALSE(sampler.readsDerivatives);
    EXPECT_FALSE(sampler.readsR);
    constexpr int room = SampleRow::capacity + 8;
    for (const Kernel* kernel : kernels()) {
        for (int count = 1; count <= SampleRow::capacity; ++count) {
            std::array<glm::vec4, room> colors{};
            colors.fill(glm::vec4(-1));
            kernel->sample(sampler, row, count, colors.data());
            const int lanes = kernel->lanes;
            for (int i = 0; i < room; ++i) {
                const bool written = i < (count + lanes - 1) / lanes * lanes;
                EXPECT_EQ(colors[static_cast<std::size_t>(i)].a >= 0, written)
                    << i << " of " << count << ", " << lanes << " lanes";
            }
        }
    }
}

TEST(Lanes, TakeTheLogarithmToFourUnitsInTheLastPlace) {
    for (std::uint32_t bits = 0x00800000; bits < 0x7F800000; bits += 9973) {
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        const double exact = std::log2(static_cast<double>(value));
        const float size = std::abs(static_cast<float>(exact));
        const float unit = std::nextafter(size, infinity) - size;
        ASSERT_NEAR(logarithm2(value), exact, 4 * static_cast<double>(unit)) << value;
    }
    for (int power = -126; power < 128; ++power)
        EXPECT_EQ(logarithm2(std::ldexp(1.0F, power)), static_cast<float>(power));
    EXPECT_EQ(logarithm2(0), -infinity);
    EXPECT_EQ(logarithm2(1e-40F), -infinity);
}

TEST(Lanes, RoundDownAsStdFloor) {
    for (const float value : {0.0F, 0.5F, -0.5F, 1.0F, -1.0F, 2.75F, -2.25F, 8388607.5F, -8388607.5F,
                              16777217.0F, 2147483648.0F, -4e9F, 3e38F, -3e38F, 1e-40F, -1e-40F})
        EXPECT_EQ(floored(floats(value))[2], std::floor(value));
}

} // namespace
} // namespace texplorer::reference::fast_sampler_test
