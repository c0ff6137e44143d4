
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
[[nodiscard]] Floats clampedToOne(Floats colors) {
    return lesser(floats(1), greater(floats(0), colors));
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

/// One colour, as often as there is room for it.
[[nodiscard]] Floats repeated(const glm::vec4& color) {
    return joined([&](std::size_t) { return loadColor(color); });
}
/// The alpha of each colour in all its components.
[[nodiscard]] Floats alphas(Floats colors) {
#if TEXPLORER_LANES == 8
    return _mm256_permute_ps(colors, 0xFF);
#elif defined(__SSE2__)
    return _mm_shuffle_ps(colors, colors, 0xFF);
#else
    return floats(colors[3]);
#endif
}
/// Colours with the alpha of others.
[[nodiscard]] Floats withAlphas(Floats colors, Floats others) {
    return laneNumbers() % 4 == 3 ? others : colors;
}

/// One function of tables 3.21 and 3.22, all four components; see environment.cpp.
[[nodiscard]] Floats byFunction(EnvFunction function, Floats previous, Floats source, Floats constant) {
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
        return previous * (1.0F - alphas(source)) + source * alphas(source);
    case EnvFunction::Blend:
        return previous * (1.0F - source) + constant * source;
    }
    return previous;
}

/// The colours of laneCount pixels.
using Group = std::array<Floats, laneCount / colorsAtOnce>;

/// Their bytes, a pixel in each lane.
[[nodiscard, gnu::always_inline]] inline Ints packed(const Group& colors) {
#if defined(__SSE2__)
    using Integers = long long __attribute__((vector_size(sizeof(Floats))));
    const auto rounded = [&](std::size_t i) __attribute__((always_inline)) {
        // NaN becomes 0: of two operands one of which is NaN, the second is taken.
        const Floats clamped = lesser(greater(colors[i], floats(0)), floats(1));
        return reinterpret_cast<Integers>(truncated(clamped * 255.0F + 0.5F));
    };
#endif
#if TEXPLORER_LANES == 8
    // Packing keeps to each half of a vector, so every second pixel comes to lie in the upper one.
    const __m256i halves = _mm256_packus_epi16(_mm256_packs_epi32(rounded(0), rounded(1)),
                                               _mm256_packs_epi32(rounded(2), rounded(3)));
    return reinterpret_cast<Ints>(
        _mm256_permutevar8x32_epi32(halves, _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7)));
#elif defined(__SSE2__)
    return reinterpret_cast<Ints>(
        _mm_packus_epi16(_mm_packs_epi32(rounded(0), rounded(1)), _mm_packs_epi32(rounded(2), rounded(3))));
#else
    Ints pixels;
    for (std::size_t i = 0; i < laneCount; ++i)
        reference::store({colors[i][0], colors[i][1], colors[i][2], colors[i][3]},
                         reinterpret_cast<std::byte*>(&pixels) + 4 * i);
    return pixels;
#endif
}

/// colorOf() of stored_color.h, of as many pixels.
[[nodiscard, gnu::always_inline]] inline Group unpacked(const std::byte* pixels) {
    std::array<std::int32_t, laneCount> words;
    std::memcpy(words.data(), pixels, sizeof words);
    Group colors;
    for (std::size_t part = 0; part < colors.size(); ++part)
        colors[part] = numbersOf([&](std::size_t i) { return words[part * colorsAtOnce + i]; });
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

    /// Which of so many lanes are still there.
    [[nodiscard]] Mask alive(int i) const { return alive_ >> i & ((1U << laneCount) - 1); }
    [[nodiscard]] Ints aliveLanes(int i) const {
        return (ints(static_cast<int>(alive(i))) & (1 << laneNumbers())) != 0;
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
            if (alive(i) == 0)
                continue;
            const Floats distances = distance.at(load(x_.data() + i)) * load(w_.data() + i);
            for (int lane = 0; lane < laneCount; ++lane)
                fog_[static_cast<std::size_t>(i + lane)] = fogFactor(fog, distances[lane]);
        }
    }

    /// fragmentColor() of shade.h, then sections 4.1.4 (alpha test) and 4.1.8 (blending).
    void color() {
        if (triangle_.evenPrimary) {
            const Floats even = clampedToOne(repeated(*triangle_.evenPrimary));
            texture([even](std::size_t) { return even; });
        } else {
            const Plane<glm::vec4>& plane = triangle_.primary;
            const Floats start = repeated(plane.origin) + repeated(plane.dy) * offsetY_;
            texture([this, start, dx = repeated(plane.dx)](std::size_t at) {
                return clampedToOne((start + dx * spreadFrom(&x_[at])) * spreadFrom(&w_[at]));
            });
        }
    }

    template<class Primary>
    void texture(const Primary& primaryAt) {
        const TextureStep& first = pass_.steps[0];
        const bool simple = pass_.stepCount == 1 && !pass_.separateSpecular && !pass_.fog;
        if (simple && first.cell.color == EnvFunction::Product) {
            if (first.cell.alpha == EnvFunction::Product)
                return modulate<true>(samples_[first.unit], primaryAt);
            if (first.cell.alpha == EnvFunction::Previous)
                return modulate<false>(samples_[first.unit], primaryAt);
        }
        eachGroup([&](std::size_t at) {
            const Floats primary = primaryAt(at);
            Floats result = primary;
            for (const TextureStep& step : std::span(pass_.steps).first(pass_.stepCount))
                result = applied(step, at, primary, result);
            if (pass_.separateSpecular)
                result = clampedToOne(result + secondary(at));
            if (pass_.fog) {
                const Floats left = spreadFrom(&fog_[at]);
                const Floats mixed = result * left + clampedToOne(repeated(pass_.fog->color)) * (1.0F - left);
                result = withAlphas(mixed, result);
            }
            return result;
        });
    }

    /// What most scenes do, to alpha as well or not.
    template<bool alsoAlpha, class Primary>
    [[gnu::always_inline]] void modulate(const Samples& samples, const Primary& primaryAt) {
        eachGroup([&](std::size_t at) __attribute__((always_inline)) {
            const Floats primary = primaryAt(at);
            const Floats product = primary * loadAs<Floats>(&samples[at]);
            return clampedToOne(alsoAlpha ? product : withAlphas(product, primary));
        });
    }

    /// Finishes the pixels with the colours that `colorsAt` gives, colorsAtOnce of them from a place on.
    template<class ColorsAt>
    [[gnu::always_inline]] void eachGroup(const ColorsAt& colorsAt) {
        for (int i = begin_; i < count_; i += laneCount) {
            if (alive(i) == 0)
                continue;
            Group colors;
            for (std::size_t part = 0; part < colors.size(); ++part)
                colors[part] = colorsAt(static_cast<std::size_t>(i) + part * colorsAtOnce);
            finish(i, colors);
        }
    }

    [[nodiscard]] Floats secondary(std::size_t at) const {
        const Plane<glm::vec4>& plane = triangle_.secondary;
        return clampedToOne((repeated(plane.origin) + repeated(plane.dy) * offsetY_ +
                             repeated(plane.dx) * spreadFrom(&x_[at])) *
                            spreadFrom(&w_[at]));
    }

    [[nodiscard]] Floats applied(const TextureStep& step, std::size_t at, Floats primary,
                                 Floats previous) const {
        if (step.combines)
            return combined(step, at, primary, previous);
        const auto source = loadAs<Floats>(&samples_[step.unit][at]);
        const Floats constant = repeated(pass_.units[step.unit].envColor);
        const Floats color = byFunction(step.cell.color, previous, source, constant);
        if (step.cell.alpha == step.cell.color)
            return clampedToOne(color);
        return clampedToOne(withAlphas(color, byFunction(step.cell.alpha, previous, source, constant)));
    }

    [[nodiscard]] Floats combined(const TextureStep& step, std::size_t at, Floats primary,
                                  Floats previous) const {
        std::array<glm::vec4, colorsAtOnce> primaries;
        std::array<glm::vec4, colorsAtOnce> results;
        store(primary, primaries.data());
        store(previous, results.data());
        const UnitState& unit = pass_.units[step.unit];
        for (std::size_t i = 0; i < colorsAtOnce; ++i) {
            std::array<const glm::vec4*, maxUnits> sources{};
            for (std::size_t u = 0; u < static_cast<std::size_t>(pass_.unitsUsed); ++u) {
                if (pass_.units[u].texture)
                    sources[u] = &samples_[u][at + i];
            }
            results[i] =
                evaluate(unit.unit->combine,
                         {results[i], samples_[step.unit][at + i], unit.envColor, primaries[i]}, sources)
                    .color;
        }
        return loadAs<Floats>(results.data());
    }

    [[gnu::always_inline]] void finish(int i, const Group& colors) {
        const Pass& pass = *pass_.pass;
        if (pass.alphaTest)
            testAlpha(i, colors);
        write(i, pass.blend ? blended(i, colors) : colors);
    }

    void testAlpha(int i, const Group& colors) {
        std::array<glm::vec4, laneCount> numbers;
        std::memcpy(numbers.data(), colors.data(), sizeof numbers);
        const float with = std::clamp(pass_.pass->alphaRef, 0.0F, 1.0F);
        for (std::size_t lane = 0; lane < laneCount; ++lane) {
            if (!passes(pass_.pass->alphaFunc, numbers[lane].a, with))
                alive_ &= ~(Mask{1} << (static_cast<std::size_t>(i) + lane));
        }
    }

    /// blend() of fragment.h, before the clamp, which follows when it is stored.
    [[nodiscard]] Group blended(int i, const Group& sources) const {
        const Group destinations = unpacked(pixels_ + std::ptrdiff_t{4} * i);
        const Group bySource = factors(pass_.pass->blendSrc, sources, destinations);
        const Group byDestination = factors(pass_.pass->blendDst, sources, destinations);
        Group result;
        for (std::size_t part = 0; part < result.size(); ++part)
            result[part] = sources[part] * bySource[part] + destinations[part] * byDestination[part];
        return result;
    }

    /// blendFactor() of fragment.h.
    [[nodiscard]] static Group factors(BlendFactor factor, const Group& sources, const Group& destinations) {
        const auto each = [&](const auto& factorOf) {
            Group result;
            for (std::size_t part = 0; part < result.size(); ++part)
                result[part] = factorOf(part);
            return result;
        };
        switch (factor) {
        case BlendFactor::Zero:
            return each([&](std::size_t) { return floats(0); });
        case BlendFactor::One:
            break;
        case BlendFactor::SrcColor:
            return sources;
        case BlendFactor::OneMinusSrcColor:
            return each([&](std::size_t part) { return 1.0F - sources[part]; });
        case BlendFactor::SrcAlpha:
            return each([&](std::size_t part) { return alphas(sources[part]); });
        case BlendFactor::OneMinusSrcAlpha:
            return each([&](std::size_t part) { return 1.0F - alphas(sources[part]); });
        case BlendFactor::DstAlpha:
            return each([&](std::size_t part) { return alphas(destinations[part]); });
        case BlendFactor::OneMinusDstAlpha:
            return each([&](std::size_t part) { return 1.0F - alphas(destinations[part]); });
        case BlendFactor::DstColor:
            return destinations;
        case BlendFactor::OneMinusDstColor:
            return each([&](std::size_t part) { return 1.0F - destinations[part]; });
        }
        return each([&](std::size_t) { return floats(1); });
    }

    [[gnu::always_inline]] void write(int i, const Group& colors) {
        std::byte* pixels = pixels_ + std::ptrdiff_t{4} * i;
        Ints there;
        std::memcpy(&there, pixels, sizeof there);
        there = aliveLanes(i) ? packed(colors) : there;
        std::memcpy(pixels, &there, sizeof there);
    }

    void writeDepth() {
        for (int i = begin_; i < count_; i += laneCount)
            store(aliveLanes(i) ? loadAs<Ints>(depth_.data() + i) : loadAs<Ints>(depthBuffer_ + i),
                  depthBuffer_ + i);
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
