#include "core/reference/fast_shade.h"

#include "core/reference/combine.h"
#include "core/reference/environment.h"
#include "core/reference/fragment.h"
#include "core/reference/lanes.h"
#include "core/reference/pass_state.h"
#include "core/reference/stored_color.h"

#include <bit>

namespace texplorer::reference {

namespace {

static_assert(rowCapacity == 32, "a bit for every pixel");
using Mask = std::uint32_t;

using Colors = std::array<glm::vec4, rowCapacity>;

/// A plane along one row.
struct RowPlane {
    float start;
    float dx;

    RowPlane(const Plane<float>& plane, float y)
        : start(plane.origin + plane.dy * y)
        , dx(plane.dx) {}
    RowPlane(const Plane<glm::vec4>& plane, int component, float y)
        : start(plane.origin[component] + plane.dy[component] * y)
        , dx(plane.dx[component]) {}

    [[nodiscard]] Floats at(Floats x) const { return start + dx * x; }
};

/// glm::clamp to [0, 1], which keeps a NaN.
[[nodiscard]] Floats clampedToOne(Floats values) {
    return lesser(floats(1), greater(floats(0), values));
}

/// fragmentDepth() of shade.h, from depths between 0 and 1. The products are exact in double precision.
[[nodiscard]] Ints depths(Floats values) {
#if defined(__SSE2__)
    const auto half = [](__m128 two) {
        return _mm_cvttpd_epi32(
            _mm_add_pd(_mm_mul_pd(_mm_cvtps_pd(two), _mm_set1_pd(farthestDepth)), _mm_set1_pd(0.5)));
    };
    return reinterpret_cast<Ints>(_mm_unpacklo_epi64(half(values), half(_mm_movehl_ps(values, values))));
#else
    Ints result{};
    for (int i = 0; i < laneCount; ++i)
        result[i] = static_cast<int>(double{values[i]} * farthestDepth + 0.5);
    return result;
#endif
}

[[nodiscard]] Ints passing(CompareFunc function, Ints values, Ints with) {
    switch (function) {
    case CompareFunc::Never:
        return ints(0);
    case CompareFunc::Less:
        return values < with;
    case CompareFunc::Equal:
        return values == with;
    case CompareFunc::LessEqual:
        return values <= with;
    case CompareFunc::Greater:
        return values > with;
    case CompareFunc::NotEqual:
        return values != with;
    case CompareFunc::GreaterEqual:
        return values >= with;
    case CompareFunc::Always:
        return ints(-1);
    }
    return ints(-1);
}

/// One bit a lane.
[[nodiscard]] Mask bits(Ints mask) {
#if defined(__SSE2__)
    return static_cast<Mask>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    return (mask[0] & 1U) | (mask[1] & 2U) | (mask[2] & 4U) | (mask[3] & 8U);
#endif
}

/// One function of tables 3.21 and 3.22, all four components; see environment.cpp.
[[nodiscard]] Floats applied(EnvFunction function, Floats previous, Floats source, Floats constant) {
    switch (function) {
    case EnvFunction::Previous:
    case EnvFunction::Undefined:
        return previous;
    case EnvFunction::Source:
        return source;
    case EnvFunction::Product:
        return previous * source;
    case EnvFunction::Sum:
        return previous + source;
    case EnvFunction::Decal:
        return previous * (1 - source[3]) + source * source[3];
    case EnvFunction::Blend:
        return previous * (1.0F - source) + constant * source;
    }
    return previous;
}

/// The bytes of four pixels.
[[nodiscard]] std::array<std::uint32_t, laneCount> packed(const glm::vec4* colors) {
    std::array<std::uint32_t, laneCount> pixels{};
#if defined(__SSE2__)
    const auto rounded = [&](int i) {
        // NaN becomes 0: of two operands one of which is NaN, the second is taken.
        const Floats clamped = lesser(greater(load(colors + i), floats(0)), floats(1));
        return reinterpret_cast<__m128i>(truncated(clamped * 255.0F + 0.5F));
    };
    const __m128i bytes =
        _mm_packus_epi16(_mm_packs_epi32(rounded(0), rounded(1)), _mm_packs_epi32(rounded(2), rounded(3)));
    std::memcpy(pixels.data(), &bytes, sizeof pixels);
#else
    for (std::size_t i = 0; i < laneCount; ++i)
        store(colors[i], reinterpret_cast<std::byte*>(&pixels[i]));
#endif
    return pixels;
}

/// Neighbouring pixels of a row. Everything is computed for whole groups of four; `alive_` says which of them
/// are there, and have not failed a test.
class Row {
public:
    Row(const Triangle& triangle, int x, int y, int count, Canvas& canvas)
        : triangle_(triangle)
        , pass_(*triangle.pass)
        , canvas_(canvas)
        , x_(x)
        , y_(y)
        , count_(count)
        , offsetY_(static_cast<float>(y) - triangle.origin.y)
        , alive_(~Mask{0} >> (rowCapacity - count)) {}

    void draw() {
        if (pass_.pass->depthTest && !testDepth())
            return;
        color();
        if (pass_.pass->alphaTest)
            testAlpha();
        if (pass_.pass->depthTest)
            writeDepth();
        if (pass_.pass->blend)
            blendColors();
        else
            writeColors();
    }

private:
    [[nodiscard]] std::size_t pixelAt(int i) const {
        return static_cast<std::size_t>(y_) * static_cast<std::size_t>(canvas_.color.width) +
               static_cast<std::size_t>(x_ + i);
    }
    [[nodiscard]] bool alive(int i) const { return (alive_ >> i & 1) != 0; }

    /// From the pixels' centres to the triangle's origin.
    [[nodiscard]] Floats offsetsX(int i) const {
        const int x = x_ + i;
        return toFloats(Ints{x, x + 1, x + 2, x + 3}) - triangle_.origin.x;
    }

    bool testDepth() {
        const RowPlane plane(triangle_.depth, offsetY_);
        std::array<std::int32_t, rowCapacity> stored{};
        std::memcpy(stored.data(), canvas_.depth.data() + pixelAt(0),
                    static_cast<std::size_t>(count_) * sizeof stored[0]);
        Mask passed = 0;
        for (int i = 0; i < count_; i += laneCount) {
            // NaN becomes 0: see fragmentDepth().
            const Floats depth = lesser(greater(plane.at(offsetsX(i)), floats(0)), floats(1));
            const Ints found = depths(depth);
            store(found, depth_.data() + i);
            passed |= bits(passing(pass_.pass->depthFunc, found, loadAs<Ints>(stored.data() + i))) << i;
        }
        alive_ &= passed;
        if (alive_ == 0)
            return false;
        begin_ = std::countr_zero(alive_) / laneCount * laneCount;
        count_ = rowCapacity - std::countl_zero(alive_);
        return true;
    }

    /// fragmentColor() of shade.h.
    void color() {
        const RowPlane invW(triangle_.invW, offsetY_);
        for (int i = begin_; i < count_; i += laneCount)
            store(1.0F / invW.at(offsetsX(i)), w_.data() + i);
        interpolate(triangle_.primary, primary_);
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            if (pass_.units[u].texture)
                sample(u);
        }
        color_ = primary_;
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            if (pass_.units[u].texture)
                applyEnvironment(u);
        }
        if (pass_.separateSpecular) {
            Colors secondary;
            interpolate(triangle_.secondary, secondary);
            for (int i = begin_; i < count_; ++i) {
                const auto at = static_cast<std::size_t>(i);
                store(clampedToOne(load(color_[at]) + load(secondary[at])), &color_[at]);
            }
        }
    }

    void interpolate(const Plane<glm::vec4>& plane, Colors& colors) const {
        const Floats start = load(plane.origin) + load(plane.dy) * offsetY_;
        const Floats dx = load(plane.dx);
        for (int i = begin_; i < count_; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const float x = static_cast<float>(x_ + i) - triangle_.origin.x;
            store(clampedToOne((start + dx * x) * w_[at]), &colors[at]);
        }
    }

    void sample(std::size_t unit) {
        const FastSampler& sampler = pass_.units[unit].sampler;
        const Plane<glm::vec4>& plane = triangle_.texCoords[unit];
        const RowPlane q(plane, 3, offsetY_);
        const auto axis = [&](int component, SampleRow::Numbers& coords, SampleRow::Numbers& byX,
                              SampleRow::Numbers& byY) {
            const RowPlane coord(plane, component, offsetY_);
            for (int i = begin_; i < count_; i += laneCount) {
                const Floats x = offsetsX(i);
                const Floats overW = q.at(x);
                const Floats value = coord.at(x) / overW;
                const int to = i - begin_;
                store(value, coords.data() + to);
                if (!sampler.readsDerivatives())
                    continue;
                store((plane.dx[component] - value * plane.dx.q) / overW, byX.data() + to);
                store((plane.dy[component] - value * plane.dy.q) / overW, byY.data() + to);
            }
        };
        SampleRow places;
        axis(0, places.s, places.dsdx, places.dsdy);
        axis(1, places.t, places.dtdx, places.dtdy);
        if (sampler.readsR())
            axis(2, places.r, places.drdx, places.drdy);
        sampler(places, count_ - begin_, samples_[unit].data() + begin_);
    }

    void applyEnvironment(std::size_t u) {
        const UnitState& unit = pass_.units[u];
        if (unit.unit->envMode == EnvMode::Combine)
            return combine(u);
        const EnvCell cell = environmentCell(unit.unit->envMode, unit.texture->format);
        const Floats constant = load(unit.envColor);
        const Ints alphaLane{0, 0, 0, -1};
        const auto each = [&](const auto& function) {
            for (int i = begin_; i < count_; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const Floats result = function(load(color_[at]), load(samples_[u][at]));
                store(clampedToOne(result), &color_[at]);
            }
        };
        if (cell.color == EnvFunction::Product && cell.alpha == EnvFunction::Product)
            return each([](Floats previous, Floats source) { return previous * source; });
        each([&](Floats previous, Floats source) {
            return alphaLane ? applied(cell.alpha, previous, source, constant)
                             : applied(cell.color, previous, source, constant);
        });
    }

    void combine(std::size_t u) {
        const UnitState& unit = pass_.units[u];
        for (int i = begin_; i < count_; ++i) {
            const auto at = static_cast<std::size_t>(i);
            std::array<const glm::vec4*, maxUnits> sources{};
            for (std::size_t other = 0; other < static_cast<std::size_t>(pass_.unitsUsed); ++other) {
                if (pass_.units[other].texture)
                    sources[other] = &samples_[other][at];
            }
            const EnvironmentInputs inputs{color_[at], samples_[u][at], unit.envColor, primary_[at]};
            color_[at] = evaluate(unit.unit->combine, inputs, sources).color;
        }
    }

    void testAlpha() {
        const float reference = std::clamp(pass_.pass->alphaRef, 0.0F, 1.0F);
        for (int i = begin_; i < count_; ++i) {
            if (!passes(pass_.pass->alphaFunc, color_[static_cast<std::size_t>(i)].a, reference))
                alive_ &= ~(Mask{1} << i);
        }
    }

    void writeDepth() {
        for (int i = begin_; i < count_; ++i) {
            if (alive(i))
                canvas_.depth[pixelAt(i)] = static_cast<std::uint32_t>(depth_[static_cast<std::size_t>(i)]);
        }
    }

    void writeColors() {
        std::byte* pixels = canvas_.color.pixels.data() + 4 * pixelAt(0);
        for (int i = begin_; i < count_; i += laneCount) {
            const auto four = packed(color_.data() + i);
            if ((alive_ >> i & 15) == 15) {
                std::memcpy(pixels + 4 * i, four.data(), sizeof four);
                continue;
            }
            for (int lane = 0; lane < laneCount; ++lane) {
                if (i + lane < rowCapacity && alive(i + lane))
                    std::memcpy(pixels + 4 * (i + lane), &four[static_cast<std::size_t>(lane)], 4);
            }
        }
    }

    void blendColors() {
        std::byte* pixels = canvas_.color.pixels.data() + 4 * pixelAt(0);
        for (int i = begin_; i < count_; ++i) {
            if (alive(i))
                store(blend(pass_.pass->blendSrc, pass_.pass->blendDst, color_[static_cast<std::size_t>(i)],
                            colorOf(pixels + 4 * i)),
                      pixels + 4 * i);
        }
    }

    const Triangle& triangle_;
    const PassState& pass_;
    Canvas& canvas_;
    int x_;
    int y_;
    int begin_ = 0; ///< a multiple of 4
    int count_;
    float offsetY_;
    Mask alive_;
    std::array<std::int32_t, rowCapacity> depth_;
    std::array<float, rowCapacity> w_;
    Colors primary_;
    Colors color_;
    std::array<Colors, maxUnits> samples_;
};

} // namespace

void drawRow(const Triangle& triangle, int x, int y, int count, Canvas& canvas) {
    Row(triangle, x, y, count, canvas).draw();
}

} // namespace texplorer::reference
