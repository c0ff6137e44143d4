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

/// fragmentDepth() of shade.h. The products are exact in double precision.
[[nodiscard]] Ints depthsOf(Floats unclamped) {
    const Floats values = lesser(greater(unclamped, floats(0)), floats(1)); // NaN becomes 0
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

using Group = std::array<Floats, laneCount>; ///< the colours of four pixels

[[nodiscard]] glm::vec4 colorOf(Floats color) {
    return {color[0], color[1], color[2], color[3]};
}

/// Their bytes.
[[nodiscard]] std::array<std::uint32_t, laneCount> packed(const Group& colors) {
    std::array<std::uint32_t, laneCount> pixels{};
#if defined(__SSE2__)
    const auto rounded = [&](std::size_t i) {
        // NaN becomes 0: of two operands one of which is NaN, the second is taken.
        const Floats clamped = lesser(greater(colors[i], floats(0)), floats(1));
        return reinterpret_cast<__m128i>(truncated(clamped * 255.0F + 0.5F));
    };
    const __m128i bytes =
        _mm_packus_epi16(_mm_packs_epi32(rounded(0), rounded(1)), _mm_packs_epi32(rounded(2), rounded(3)));
    std::memcpy(pixels.data(), &bytes, sizeof pixels);
#else
    for (std::size_t i = 0; i < laneCount; ++i)
        store(colorOf(colors[i]), reinterpret_cast<std::byte*>(&pixels[i]));
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
        , depthBuffer_(canvas.depth.data() + canvas.pixelAt(x, y))
        , pixels_(canvas.color.pixels.data() + 4 * canvas.pixelAt(x, y))
        , firstX_(x)
        , count_(count)
        , offsetY_(static_cast<float>(y) - triangle.origin.y)
        , alive_(~Mask{0} >> (rowCapacity - count)) {}

    /// With the depth test.
    void drawTested() {
        if (pass_.pass->depthTest && !testDepth())
            return;
        draw();
        if (pass_.pass->depthTest)
            writeDepth();
    }

    void draw() {
        const RowPlane invW(triangle_.invW, offsetY_);
        for (int i = begin_; i < count_; i += laneCount) {
            const Floats x = offsetsX(i);
            store(x, x_.data() + i);
            store(1.0F / invW.at(x), w_.data() + i);
        }
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            if (pass_.units[u].texture)
                sample(u);
        }
        color();
    }

private:
    /// What a unit does to the colour.
    struct Step {
        EnvCell cell;
        Floats constant;
        std::size_t unit;
        bool combines;
    };

    /// Of pixels to the right of the first: from their centres to the triangle's origin.
    [[nodiscard]] Floats offsetsX(int i) const {
        return toFloats(ints(firstX_ + i) + Ints{0, 1, 2, 3}) - triangle_.origin.x;
    }

    /// Four bits: which of a group are still there.
    [[nodiscard]] Mask alive(int i) const { return alive_ >> i & 15; }
    template<class Work>
    void forEachAlive(int i, const Work& work) const {
        for (Mask left = alive(i); left != 0; left &= left - 1)
            work(std::countr_zero(left));
    }

    bool testDepth() {
        const RowPlane plane(triangle_.depth, offsetY_);
        Mask passed = 0;
        for (int i = 0; i < count_; i += laneCount) {
            const Ints found = depthsOf(plane.at(offsetsX(i)));
            store(found, depth_.data() + i);
            Ints stored = ints(0);
            if (i + laneCount <= count_)
                stored = loadAs<Ints>(depthBuffer_ + i);
            else // what lies beyond may be another thread's
                forEachAlive(i, [&](int lane) { stored[lane] = static_cast<int>(depthBuffer_[i + lane]); });
            passed |= bits(passing(pass_.pass->depthFunc, found, stored)) << i;
        }
        alive_ &= passed;
        if (alive_ == 0)
            return false;
        begin_ = std::countr_zero(alive_) / laneCount * laneCount;
        count_ = rowCapacity - std::countl_zero(alive_);
        return true;
    }

    void sample(std::size_t unit) {
        const FastSampler& sampler = pass_.units[unit].sampler;
        SampleRow places;
        if (sampler.readsDerivatives())
            place<true>(unit, places);
        else
            place<false>(unit, places);
        sampler(places, count_ - begin_, samples_[unit].data() + begin_);
    }

    /// texturePlace() of shade.h.
    template<bool derivatives>
    void place(std::size_t unit, SampleRow& places) const {
        const Plane<glm::vec4>& plane = triangle_.texCoords[unit];
        const RowPlane q(plane, 3, offsetY_);
        const auto axis = [&](int component, SampleRow::Numbers& coords, SampleRow::Numbers& byX,
                              SampleRow::Numbers& byY) {
            const RowPlane coord(plane, component, offsetY_);
            for (int i = begin_; i < count_; i += laneCount) {
                const Floats x = load(x_.data() + i);
                const Floats overW = q.at(x);
                const Floats value = coord.at(x) / overW;
                const int to = i - begin_;
                store(value, coords.data() + to);
                if (derivatives) {
                    store((plane.dx[component] - value * plane.dx.q) / overW, byX.data() + to);
                    store((plane.dy[component] - value * plane.dy.q) / overW, byY.data() + to);
                }
            }
        };
        axis(0, places.s, places.dsdx, places.dsdy);
        axis(1, places.t, places.dtdx, places.dtdy);
        if (pass_.units[unit].sampler.readsR())
            axis(2, places.r, places.drdx, places.drdy);
    }

    /// fragmentColor() of shade.h, then sections 4.1.4 (alpha test) and 4.1.8 (blending).
    void color() {
        std::array<Step, maxUnits> steps;
        std::size_t stepCount = 0;
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            const UnitState& unit = pass_.units[u];
            if (unit.texture)
                steps[stepCount++] = {environmentCell(unit.unit->envMode, unit.texture->format),
                                      load(unit.envColor), u, unit.unit->envMode == EnvMode::Combine};
        }
        const bool modulates = stepCount == 1 && !steps[0].combines && !pass_.separateSpecular &&
                               !pass_.pass->alphaTest && !pass_.pass->blend &&
                               steps[0].cell.color == EnvFunction::Product &&
                               steps[0].cell.alpha == EnvFunction::Product;
        const Floats start = load(triangle_.primary.origin) + load(triangle_.primary.dy) * offsetY_;
        const Floats dx = load(triangle_.primary.dx);
        for (int i = begin_; i < count_; i += laneCount) {
            if (alive(i) == 0)
                continue;
            Group colors;
            for (int lane = 0; lane < laneCount; ++lane) {
                const auto at = static_cast<std::size_t>(i + lane);
                const Floats primary = clampedToOne((start + dx * x_[at]) * w_[at]);
                Floats& result = colors[static_cast<std::size_t>(lane)];
                if (modulates) { // what most scenes do; packed() clamps it
                    result = primary * load(samples_[steps[0].unit][at]);
                    continue;
                }
                result = primary;
                for (std::size_t step = 0; step < stepCount; ++step)
                    result = applied(steps[step], at, primary, result);
                if (pass_.separateSpecular)
                    result = clampedToOne(result + secondary(at));
            }
            finish(i, colors);
        }
    }

    [[nodiscard]] Floats secondary(std::size_t i) const {
        const Plane<glm::vec4>& plane = triangle_.secondary;
        return clampedToOne((load(plane.origin) + load(plane.dy) * offsetY_ + load(plane.dx) * x_[i]) *
                            w_[i]);
    }

    [[nodiscard]] Floats applied(const Step& step, std::size_t at, Floats primary, Floats previous) const {
        const Floats source = load(samples_[step.unit][at]);
        if (step.combines)
            return combined(step, at, primary, previous);
        const Floats color = reference::applied(step.cell.color, previous, source, step.constant);
        const Floats alpha = step.cell.alpha == step.cell.color
                                 ? color
                                 : reference::applied(step.cell.alpha, previous, source, step.constant);
        return clampedToOne(Ints{0, 0, 0, -1} ? alpha : color);
    }

    [[nodiscard]] Floats combined(const Step& step, std::size_t at, Floats primary, Floats previous) const {
        std::array<const glm::vec4*, maxUnits> sources{};
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            if (pass_.units[u].texture)
                sources[u] = &samples_[u][at];
        }
        const UnitState& unit = pass_.units[step.unit];
        return load(evaluate(unit.unit->combine,
                             {colorOf(previous), samples_[step.unit][at], unit.envColor, colorOf(primary)},
                             sources)
                        .color);
    }

    void finish(int i, const Group& colors) {
        const Pass& pass = *pass_.pass;
        if (pass.alphaTest) {
            const float with = std::clamp(pass.alphaRef, 0.0F, 1.0F);
            forEachAlive(i, [&](int lane) {
                if (!passes(pass.alphaFunc, colors[static_cast<std::size_t>(lane)][3], with))
                    alive_ &= ~(Mask{1} << (i + lane));
            });
        }
        std::byte* pixels = pixels_ + 4 * i;
        if (pass.blend) {
            forEachAlive(i, [&](int lane) {
                std::byte* pixel = pixels + 4 * lane;
                store(blend(pass.blendSrc, pass.blendDst, colorOf(colors[static_cast<std::size_t>(lane)]),
                            reference::colorOf(pixel)),
                      pixel);
            });
            return;
        }
        const auto four = packed(colors);
        if (alive(i) == 15)
            std::memcpy(pixels, four.data(), sizeof four);
        else
            forEachAlive(i, [&](int lane) {
                std::memcpy(pixels + 4 * lane, &four[static_cast<std::size_t>(lane)], 4);
            });
    }

    void writeDepth() {
        for (int i = begin_; i < count_; i += laneCount) {
            if (alive(i) == 15)
                store(loadAs<Ints>(depth_.data() + i), depthBuffer_ + i);
            else
                forEachAlive(i, [&](int lane) {
                    depthBuffer_[i + lane] =
                        static_cast<std::uint32_t>(depth_[static_cast<std::size_t>(i + lane)]);
                });
        }
    }

    const Triangle& triangle_;
    const PassState& pass_;
    std::uint32_t* depthBuffer_; ///< at the first pixel
    std::byte* pixels_;
    int firstX_;
    int begin_ = 0; ///< a multiple of 4
    int count_;
    float offsetY_;
    Mask alive_;
    std::array<std::int32_t, rowCapacity> depth_;
    std::array<float, rowCapacity> x_;
    std::array<float, rowCapacity> w_;
    std::array<Colors, maxUnits> samples_;
};

} // namespace

void drawRow(const Triangle& triangle, int x, int y, int count, Canvas& canvas) {
    Row(triangle, x, y, count, canvas).drawTested();
}

void shadeRow(const Triangle& triangle, int x, int y, int count, Canvas& canvas) {
    Row(triangle, x, y, count, canvas).draw();
}

void markRow(const Triangle& triangle, std::uint32_t number, int x, int y, int count, Canvas& canvas,
             std::uint32_t* owners) {
    const Pass& pass = *triangle.pass->pass;
    if (!pass.depthTest) {
        std::fill_n(owners, count, number);
        return;
    }
    std::uint32_t* depthBuffer = canvas.depth.data() + canvas.pixelAt(x, y);
    const RowPlane plane(triangle.depth, static_cast<float>(y) - triangle.origin.y);
    const auto depthsAt = [&](int i) {
        return depthsOf(plane.at(toFloats(ints(x + i) + Ints{0, 1, 2, 3}) - triangle.origin.x));
    };
    int i = 0;
    for (; i + laneCount <= count; i += laneCount) {
        const Ints found = depthsAt(i);
        const Ints stored = loadAs<Ints>(depthBuffer + i);
        const Ints passed = passing(pass.depthFunc, found, stored);
        store(passed ? found : stored, depthBuffer + i);
        store(passed ? ints(static_cast<int>(number)) : loadAs<Ints>(owners + i), owners + i);
    }
    if (i == count)
        return;
    const Ints found = depthsAt(i);
    for (int lane = 0; i + lane < count; ++lane) {
        std::uint32_t& stored = depthBuffer[i + lane];
        const auto depth = static_cast<std::uint32_t>(found[lane]);
        if (passes(pass.depthFunc, depth, stored)) {
            stored = depth;
            owners[i + lane] = number;
        }
    }
}

} // namespace texplorer::reference
