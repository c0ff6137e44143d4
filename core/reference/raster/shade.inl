// Fragments: the bytes of shade.h and of raster.cpp's literal fragment, which are the text to read, for
// several pixels at a time. Compiled once for each number of lanes: see kernel.h.

static_assert(rowCapacity == 32, "a bit for every pixel");
using Mask = std::uint32_t;

using Samples = std::array<glm::vec4, rowCapacity>;

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
[[nodiscard]] Color clampedToOne(Color color) {
    return lesser(Color{1, 1, 1, 1}, greater(Color{}, color));
}

/// fragmentDepth() of shade.h. The products are exact in double precision.
[[nodiscard]] Ints depthsOf(Floats unclamped) {
    const Floats values = lesser(greater(unclamped, floats(0)), floats(1)); // NaN becomes 0
#if TEXPLORER_LANES == 8
    const auto half = [](__m128 four) __attribute__((always_inline)) {
        return _mm256_cvttpd_epi32(_mm256_add_pd(
            _mm256_mul_pd(_mm256_cvtps_pd(four), _mm256_set1_pd(farthestDepth)), _mm256_set1_pd(0.5)));
    };
    return reinterpret_cast<Ints>(
        _mm256_set_m128i(half(_mm256_extractf128_ps(values, 1)), half(_mm256_castps256_ps128(values))));
#elif defined(__SSE2__)
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

/// One function of tables 3.21 and 3.22, all four components; see environment.cpp.
[[nodiscard]] Color byFunction(EnvFunction function, Color previous, Color source, Color constant) {
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

/// Colours are stored in fours, whatever the number of lanes: they are bytes then.
constexpr int groupSize = 4;
using Group = std::array<Color, groupSize>;

[[nodiscard]] glm::vec4 vectorOf(Color color) {
    return {color[0], color[1], color[2], color[3]};
}

/// Their bytes.
[[nodiscard, gnu::always_inline]] inline ColorBits packed(const Group& colors) {
#if defined(__SSE2__)
    const auto rounded = [&](std::size_t i) __attribute__((always_inline)) {
        // NaN becomes 0: of two operands one of which is NaN, the second is taken.
        const Color clamped = lesser(greater(colors[i], Color{}), Color{1, 1, 1, 1});
        return _mm_cvttps_epi32(clamped * 255.0F + 0.5F);
    };
    return reinterpret_cast<ColorBits>(
        _mm_packus_epi16(_mm_packs_epi32(rounded(0), rounded(1)), _mm_packs_epi32(rounded(2), rounded(3))));
#else
    std::array<std::byte, 4 * groupSize> bytes{};
    for (std::size_t i = 0; i < groupSize; ++i)
        reference::store(vectorOf(colors[i]), bytes.data() + 4 * i);
    ColorBits pixels;
    std::memcpy(&pixels, bytes.data(), sizeof pixels);
    return pixels;
#endif
}

/// colorOf() of stored_color.h, of as many pixels.
[[nodiscard, gnu::always_inline]] inline Group unpacked(const std::byte* pixels) {
    using Bytes = std::uint8_t __attribute__((vector_size(4)));
    Group colors;
    for (std::size_t i = 0; i < groupSize; ++i) {
        Bytes bytes;
        std::memcpy(&bytes, pixels + 4 * i, sizeof bytes);
        colors[i] = __builtin_convertvector(bytes, Color) / 255.0F;
    }
    return colors;
}

/// Neighbouring pixels of a row. Everything is computed for as many as there are lanes; `alive_` says which
/// of them are there, and have not failed a test.
class Row {
public:
    Row(const Triangle& triangle, const PixelRow& pixels)
        : triangle_(triangle)
        , pass_(*triangle.pass)
        , depthBuffer_(pixels.depth)
        , pixels_(pixels.colors)
        , firstX_(pixels.x)
        , count_(pixels.count)
        , offsetY_(static_cast<float>(pixels.y) - triangle.origin.y)
        , alive_(~Mask{0} >> (rowCapacity - pixels.count)) {}

    /// With the depth test.
    void drawTested() {
        if (pass_.pass->depthTest && !testDepth())
            return;
        draw();
        if (pass_.pass->depthTest)
            writeDepth();
    }

    void draw() {
        for (int i = begin_; i < count_; i += laneCount)
            store(offsetsX(i), x_.data() + i);
        if (!triangle_.evenPrimary || pass_.separateSpecular || pass_.fog) {
            const RowPlane invW(triangle_.invW, offsetY_);
            for (int i = begin_; i < count_; i += laneCount)
                store(1.0F / invW.at(load(x_.data() + i)), w_.data() + i);
        }
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            if (pass_.units[u].texture)
                sample(u);
        }
        if (pass_.fog)
            fog(*pass_.fog);
        color();
    }

private:
    /// Of pixels to the right of the first: from their centres to the triangle's origin.
    [[nodiscard]] Floats offsetsX(int i) const {
        return toFloats(ints(firstX_ + i) + laneNumbers()) - triangle_.origin.x;
    }

    static constexpr Mask wholeGroup = (1U << groupSize) - 1;
    static constexpr Mask allLanes = (1U << laneCount) - 1;

    /// Which of a group, or of so many lanes, are still there.
    [[nodiscard]] Mask alive(int i, Mask all) const { return alive_ >> i & all; }
    template<class Work>
    void forEachAlive(int i, Mask all, const Work& work) const {
        for (Mask left = alive(i, all); left != 0; left &= left - 1)
            work(std::countr_zero(left));
    }

    bool testDepth() {
        const RowPlane plane(triangle_.depth, offsetY_);
        Mask passed = 0;
        for (int i = 0; i < count_; i += laneCount) {
            const Ints found = depthsOf(plane.at(offsetsX(i)));
            store(found, depth_.data() + i);
            const Ints stored = loadAs<Ints>(depthBuffer_ + i);
            passed |= bitsOf(passing(pass_.pass->depthFunc, found, stored)) << i;
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
        if (sampler.readsDerivatives)
            place<true>(unit, places);
        else
            place<false>(unit, places);
        sampleRow(sampler, places, count_ - begin_, samples_[unit].data() + begin_);
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
        if (pass_.units[unit].sampler.readsR)
            axis(2, places.r, places.drdx, places.drdy);
    }

    /// fogFactor() of fog.h. It asks for a power of e, which has no vector of its own.
    void fog(const Fog& fog) {
        const RowPlane distance(triangle_.fogDistance, offsetY_);
        for (int i = begin_; i < count_; i += laneCount) {
            if (alive(i, allLanes) == 0)
                continue;
            const Floats distances = distance.at(load(x_.data() + i)) * load(w_.data() + i);
            for (int lane = 0; lane < laneCount; ++lane)
                fog_[static_cast<std::size_t>(i + lane)] = fogFactor(fog, distances[lane]);
        }
    }

    /// fragmentColor() of shade.h, then sections 4.1.4 (alpha test) and 4.1.8 (blending).
    void color() {
        const TextureStep& first = pass_.steps[0];
        const bool modulates = pass_.stepCount == 1 && first.cell.color == EnvFunction::Product &&
                               first.cell.alpha == EnvFunction::Product && !pass_.separateSpecular &&
                               !pass_.fog;
        if (triangle_.evenPrimary) {
            const Color even = clampedToOne(loadColor(*triangle_.evenPrimary));
            const auto primary = [even](std::size_t) { return even; };
            modulates ? modulate(samples_[first.unit], primary) : texture(primary);
        } else {
            const Color start =
                loadColor(triangle_.primary.origin) + loadColor(triangle_.primary.dy) * offsetY_;
            const auto primary = [&, start, dx = loadColor(triangle_.primary.dx)](std::size_t i) {
                return clampedToOne((start + dx * x_[i]) * w_[i]);
            };
            modulates ? modulate(samples_[first.unit], primary) : texture(primary);
        }
    }

    /// What most scenes do. What is stored at once is clamped then.
    template<class Primary>
    [[gnu::always_inline]] void modulate(const Samples& samples, const Primary& primary) {
        const bool stored = !pass_.pass->alphaTest && !pass_.pass->blend;
        for (int i = begin_; i < count_; i += groupSize) {
            const auto at = static_cast<std::size_t>(i);
            Group colors{primary(at) * loadColor(samples[at]), primary(at + 1) * loadColor(samples[at + 1]),
                         primary(at + 2) * loadColor(samples[at + 2]),
                         primary(at + 3) * loadColor(samples[at + 3])};
            if (stored) {
                write(i, colors);
                continue;
            }
            for (Color& color : colors)
                color = clampedToOne(color);
            finish(i, colors);
        }
    }

    template<class Primary>
    void texture(const Primary& primaryAt) {
        const Color fogColor = pass_.fog ? clampedToOne(loadColor(pass_.fog->color)) : Color{};
        for (int i = begin_; i < count_; i += groupSize) {
            if (alive(i, wholeGroup) == 0)
                continue;
            Group colors;
            for (int lane = 0; lane < groupSize; ++lane) {
                const auto at = static_cast<std::size_t>(i + lane);
                const Color primary = primaryAt(at);
                Color& result = colors[static_cast<std::size_t>(lane)];
                result = primary;
                for (const TextureStep& step : std::span(pass_.steps).first(pass_.stepCount))
                    result = applied(step, at, primary, result);
                if (pass_.separateSpecular)
                    result = clampedToOne(result + secondary(at));
                if (pass_.fog) {
                    const Color mixed = result * fog_[at] + fogColor * (1 - fog_[at]);
                    result = ColorBits{0, 0, 0, -1} ? result : mixed;
                }
            }
            finish(i, colors);
        }
    }

    [[nodiscard]] Color secondary(std::size_t i) const {
        const Plane<glm::vec4>& plane = triangle_.secondary;
        return clampedToOne(
            (loadColor(plane.origin) + loadColor(plane.dy) * offsetY_ + loadColor(plane.dx) * x_[i]) * w_[i]);
    }

    [[nodiscard]] Color applied(const TextureStep& step, std::size_t at, Color primary,
                                Color previous) const {
        const Color source = loadColor(samples_[step.unit][at]);
        if (step.combines)
            return combined(step, at, primary, previous);
        const Color constant = loadColor(pass_.units[step.unit].envColor);
        const Color color = byFunction(step.cell.color, previous, source, constant);
        const Color alpha = step.cell.alpha == step.cell.color
                                ? color
                                : byFunction(step.cell.alpha, previous, source, constant);
        return clampedToOne(ColorBits{0, 0, 0, -1} ? alpha : color);
    }

    [[nodiscard]] Color combined(const TextureStep& step, std::size_t at, Color primary,
                                 Color previous) const {
        std::array<const glm::vec4*, maxUnits> sources{};
        for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
            if (pass_.units[u].texture)
                sources[u] = &samples_[u][at];
        }
        const UnitState& unit = pass_.units[step.unit];
        return loadColor(
            evaluate(unit.unit->combine,
                     {vectorOf(previous), samples_[step.unit][at], unit.envColor, vectorOf(primary)}, sources)
                .color);
    }

    void finish(int i, const Group& colors) {
        const Pass& pass = *pass_.pass;
        if (pass.alphaTest) {
            const float with = std::clamp(pass.alphaRef, 0.0F, 1.0F);
            forEachAlive(i, wholeGroup, [&](int lane) {
                if (!passes(pass.alphaFunc, colors[static_cast<std::size_t>(lane)][3], with))
                    alive_ &= ~(Mask{1} << (i + lane));
            });
        }
        write(i, pass.blend ? blended(i, colors) : colors);
    }

    /// blend() of fragment.h, before the clamp, which follows when it is stored.
    [[nodiscard]] Group blended(int i, const Group& colors) const {
        const Group there = unpacked(pixels_ + std::ptrdiff_t{4} * i);
        Group result;
        for (std::size_t lane = 0; lane < groupSize; ++lane) {
            const Color source = colors[lane];
            const Color destination = there[lane];
            result[lane] = source * factor(pass_.pass->blendSrc, source, destination) +
                           destination * factor(pass_.pass->blendDst, source, destination);
        }
        return result;
    }

    /// blendFactor() of fragment.h.
    [[nodiscard, gnu::always_inline]] static Color factor(BlendFactor factor, Color source,
                                                          Color destination) {
        switch (factor) {
        case BlendFactor::Zero:
            return Color{};
        case BlendFactor::One:
            break;
        case BlendFactor::SrcColor:
            return source;
        case BlendFactor::OneMinusSrcColor:
            return 1.0F - source;
        case BlendFactor::SrcAlpha:
            return source[3] - Color{};
        case BlendFactor::OneMinusSrcAlpha:
            return (1 - source[3]) - Color{};
        case BlendFactor::DstAlpha:
            return destination[3] - Color{};
        case BlendFactor::OneMinusDstAlpha:
            return (1 - destination[3]) - Color{};
        case BlendFactor::DstColor:
            return destination;
        case BlendFactor::OneMinusDstColor:
            return 1.0F - destination;
        }
        return Color{1, 1, 1, 1};
    }

    [[gnu::always_inline]] void write(int i, const Group& colors) {
        std::byte* pixels = pixels_ + std::ptrdiff_t{4} * i;
        ColorBits bytes = packed(colors);
        if (const Mask here = alive(i, wholeGroup); here != wholeGroup) {
            ColorBits there;
            std::memcpy(&there, pixels, sizeof there);
            const int bits = static_cast<int>(here);
            bytes = (ColorBits{bits, bits, bits, bits} & ColorBits{1, 2, 4, 8}) != 0 ? bytes : there;
        }
        std::memcpy(pixels, &bytes, sizeof bytes);
    }

    void writeDepth() {
        for (int i = begin_; i < count_; i += laneCount) {
            const Ints here = (ints(static_cast<int>(alive(i, allLanes))) & (1 << laneNumbers())) != 0;
            store(here ? loadAs<Ints>(depth_.data() + i) : loadAs<Ints>(depthBuffer_ + i), depthBuffer_ + i);
        }
    }

    const Triangle& triangle_;
    const PassState& pass_;
    std::uint32_t* depthBuffer_; ///< at the first pixel
    std::byte* pixels_;
    int firstX_;
    int begin_ = 0; ///< a multiple of laneCount
    int count_;
    float offsetY_;
    Mask alive_;
    std::array<std::int32_t, rowCapacity> depth_;
    std::array<float, rowCapacity> x_;
    std::array<float, rowCapacity> w_;
    std::array<float, rowCapacity> fog_; ///< what it leaves of a colour
    std::array<Samples, maxUnits> samples_;
};

void drawRow(const Triangle& triangle, const PixelRow& row) {
    Row(triangle, row).drawTested();
}

/// How many owners are the same as the first.
[[nodiscard]] int runLength(const std::uint32_t* owners, int count) {
    const Ints first = ints(static_cast<int>(*owners));
    for (int i = 0; i < count; i += laneCount) {
        const Mask others = bitsOf(loadAs<Ints>(owners + i) != first);
        if (others != 0)
            return std::min(i + std::countr_zero(others), count);
    }
    return count;
}

void shadeRow(std::span<const Triangle> triangles, const std::uint32_t* owners, const PixelRow& row) {
    for (int i = 0, count = 0; i < row.count; i += count) {
        count = runLength(owners + i, row.count - i);
        if (owners[i] != noTriangle)
            Row(triangles[owners[i]],
                {row.x + i, row.y, count, row.depth + i, row.colors + std::ptrdiff_t{4} * i})
                .draw();
    }
}

void markRow(const Triangle& triangle, std::uint32_t number, const PixelRow& row, std::uint32_t* owners) {
    const Pass& pass = *triangle.pass->pass;
    const int count = row.count;
    if (!pass.depthTest) {
        std::fill_n(owners, count, number);
        return;
    }
    std::uint32_t* depthBuffer = row.depth;
    const RowPlane plane(triangle.depth, static_cast<float>(row.y) - triangle.origin.y);
    for (int i = 0; i < count; i += laneCount) {
        const Ints found = depthsOf(plane.at(toFloats(ints(row.x + i) + laneNumbers()) - triangle.origin.x));
        const Ints stored = loadAs<Ints>(depthBuffer + i);
        const Ints passed = passing(pass.depthFunc, found, stored) & (laneNumbers() < ints(count - i));
        store(passed ? found : stored, depthBuffer + i);
        store(passed ? ints(static_cast<int>(number)) : loadAs<Ints>(owners + i), owners + i);
    }
}

constexpr Kernel kernel{laneCount, sampleRow, drawRow, markRow, shadeRow};
