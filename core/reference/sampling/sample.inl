// Texture filtering: the numbers of sampler.h, which is the text to read, for several pixels at a time. Every
// colour is equal to sample()'s: the same operations in the same order, but nothing is computed that the
// parameters leave without effect. Compiled once for each number of lanes: see kernel.h.

using Colors = std::array<Color, laneCount>; ///< red, green, blue and alpha of neighbours

/// Calls work with 0, 1, 2, …, known when it is compiled: lanes stay in registers.
template<class Work>
[[gnu::always_inline]] inline void forEachLane(const Work& work) {
    work(std::size_t{0});
    work(std::size_t{1});
    work(std::size_t{2});
    work(std::size_t{3});
#if TEXPLORER_LANES == 8
    work(std::size_t{4});
    work(std::size_t{5});
    work(std::size_t{6});
    work(std::size_t{7});
#endif
}

/// A vector of numbers holds so many colours.
constexpr std::size_t colorsAtOnce = laneCount / 4;

/// The colours that `colorOf` gives for 0, 1, ….
template<class ColorOf>
[[nodiscard, gnu::always_inline]] inline Floats joined(const ColorOf& colorOf) {
#if TEXPLORER_LANES == 8
    return _mm256_insertf128_ps(_mm256_castps128_ps256(colorOf(0)), colorOf(1), 1);
#else
    return colorOf(0);
#endif
}
/// The numbers of as many pixels, each four times: for every component of their colours.
[[nodiscard, gnu::always_inline]] inline Floats spread(Floats values, std::size_t first) {
#if TEXPLORER_LANES == 8
    return _mm256_permutevar8x32_ps(values, _mm256_set_m128i(_mm_set1_epi32(static_cast<int>(first) + 1),
                                                             _mm_set1_epi32(static_cast<int>(first))));
#else
    return floats(values[first]);
#endif
}

/// Numbers of neighbours in memory, each for every component of a colour.
[[nodiscard, gnu::always_inline]] inline Floats spreadFrom(const float* numbers) {
    return joined([&](std::size_t i) { return numbers[i] - Color{}; });
}

/// n / 255 of a byte, to the last bit and without a division: n * 257 / 65536, which a float holds, and a
/// 65536th of itself.
template<class Number>
[[nodiscard]] constexpr Number of255(Number n) {
    return n * (257 / 65536.0F) + n * (1 / 255.0F / 65536);
}
static_assert([] {
    for (int n = 0; n < 256; ++n) {
        if (of255(static_cast<float>(n)) != static_cast<float>(n) / 255)
            return false;
    }
    return true;
}());

/// What bytes stand for: `pixelAt` gives the four of each colour.
template<class PixelAt>
[[nodiscard, gnu::always_inline]] inline Floats numbersOf(const PixelAt& pixelAt) {
#if TEXPLORER_LANES == 8
    const __m128i bytes = _mm_setr_epi32(pixelAt(0), pixelAt(1), 0, 0);
    return of255(toFloats(reinterpret_cast<Ints>(_mm256_cvtepu8_epi32(bytes))));
#elif defined(__SSE2__)
    const __m128i shorts = _mm_unpacklo_epi8(_mm_cvtsi32_si128(pixelAt(0)), _mm_setzero_si128());
    return of255(toFloats(reinterpret_cast<Ints>(_mm_unpacklo_epi16(shorts, _mm_setzero_si128()))));
#else
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(pixelAt(0));
    return of255(toFloats(Ints{bytes[0], bytes[1], bytes[2], bytes[3]}));
#endif
}

/// Texels of a level, as many.
[[nodiscard, gnu::always_inline]] inline Floats texelsAt(const glm::vec4* texels,
                                                         const std::int32_t* places) {
    return joined([&](std::size_t i) { return loadColor(texels + places[i]); });
}
[[nodiscard, gnu::always_inline]] inline Floats texelsAt(const std::int32_t* texels,
                                                         const std::int32_t* places) {
    return numbersOf([&](std::size_t i) { return texels[places[i]]; });
}

[[nodiscard]] Floats clamped(Floats values, Floats low, Floats high) {
    return greater(lesser(values, high), low);
}

/// wrapCoordinate() of wrap.h. A branch for several pixels, the same for the whole texture, costs nothing.
[[nodiscard, gnu::always_inline]] inline Floats wrapped(Wrap wrap, Floats coordinates, Floats size) {
    if (wrap == Wrap::Repeat) { // from 2^23 on floats have no fraction; what is not finite counts as 0
        const Floats fraction = coordinates - flooredSmall(coordinates);
        return (magnitude(coordinates) < floats(0x1p23F) ? fraction : floats(0)) * size;
    }
    const Floats s = isFinite(coordinates) ? coordinates : floats(0);
    switch (wrap) {
    case Wrap::Repeat:
        break;
    case Wrap::MirroredRepeat: {
        const Floats whole = floored(s);
        const Floats fraction = s - whole;
        const Floats half = whole * 0.5F;
        return clamped((half == floored(half) ? fraction : 1.0F - fraction) * size, floats(0.5F),
                       size - 0.5F);
    }
    case Wrap::ClampToEdge:
        return clamped(s * size, floats(0.5F), size - 0.5F);
    case Wrap::ClampToBorder:
        return clamped(s * size, floats(-0.5F), size + 0.5F);
    case Wrap::Clamp:
        return clamped(s * size, floats(0), size);
    }
    return floats(0);
}

/// Whether texels beyond the level are asked for, which have the border colour.
[[nodiscard]] bool reachesBorder(Wrap wrap) {
    return wrap == Wrap::ClampToBorder || wrap == Wrap::Clamp;
}

[[nodiscard]] Ints nearestTexels(Wrap wrap, Floats u, Floats size) {
    if (wrap != Wrap::ClampToBorder) // between 0 and the size
        return truncated(lesser(u, size - 1.0F));
    return truncated(u == size ? size - 1.0F : flooredSmall(u));
}

/// linearTexels() of wrap.h.
struct TexelPairs {
    Ints first;
    Ints second;
    Floats share;

    TexelPairs(Wrap wrap, Floats u, Floats size) {
        const Floats centred = u - 0.5F;
        const Floats low = flooredSmall(centred);
        share = centred - low;
        first = truncated(low);
        second = first + 1;
        const Ints extent = truncated(size);
        if (wrap == Wrap::Repeat) {
            first = first < 0 ? first + extent : first;
            second = second >= extent ? second - extent : second;
        } else if (!reachesBorder(wrap)) { // only with share 0
            second = second >= extent ? extent - 1 : second;
        }
    }
};

/// Samples for as many neighbouring pixels as there are lanes.
template<int axes>
class Pixels {
public:
    explicit Pixels(const FastSampler& sampler)
        : sampler_(sampler)
        , texture_(*sampler.texture)
        , border_(loadColor(texture_.borderColor))
        , usesBorder_(reachesBorder(texture_.wrapS) || (axes > 1 && reachesBorder(texture_.wrapT))) {}

    /// Without mipmaps, where magnification and minification are the same.
    void sampleBase(const SampleRow& row, int count, glm::vec4* colors) const {
        const OneLevel base(sampler_.planes[0]);
        const bool linear = texture_.magFilter == MagFilter::Linear;
        if (axes > 1 && linear && !usesBorder_)
            return base.shared.bytes ? weighBase(base, base.shared.bytes, row, count, colors)
                                     : weighBase(base, base.shared.texels, row, count, colors);
        for (int at = 0; at < count; at += laneCount) {
            const Floats s = load(row.s.data() + at);
            const Floats t = axes > 1 ? load(row.t.data() + at) : floats(0);
            write(linear ? linearly(base, s, t) : nearest(base, s, t), colors + at);
        }
    }

    void sample(const SampleRow& row, int count, glm::vec4* colors) const {
        for (int at = 0; at < count; at += laneCount) {
            const Place place(row, at);
            const Footprint footprint = footprintOf(place);
            if (leavesFloats(footprint, place)) {
                sampleLiterally(sampler_, row, at, std::min(laneCount, count - at), colors + at);
                continue;
            }
            const Choice choice = choose(footprint, place);
            write(any(choice.probes > 1.0F) ? probed(choice, place) : filtered(choice, place.s, place.t),
                  colors + at);
        }
    }

private:
    using Plane = FastSampler::Plane;

    struct Place {
        Floats s;
        Floats t;
        Floats dsdx;
        Floats dtdx;
        Floats dsdy;
        Floats dtdy;

        Place(const SampleRow& row, int at)
            : s(load(row.s.data() + at))
            , t(axes > 1 ? load(row.t.data() + at) : floats(0))
            , dsdx(load(row.dsdx.data() + at))
            , dtdx(axes > 1 ? load(row.dtdx.data() + at) : floats(0))
            , dsdy(load(row.dsdy.data() + at))
            , dtdy(axes > 1 ? load(row.dtdy.data() + at) : floats(0)) {}
    };

    /// A level that all pixels share.
    struct OneLevel {
        const Plane& shared;
        Floats width;
        Floats height;
        Ints rowLength;

        explicit OneLevel(const Plane& plane)
            : shared(plane)
            , width(floats(plane.fWidth))
            , height(floats(plane.fHeight))
            , rowLength(ints(plane.width)) {}

        [[nodiscard]] const Plane& of(std::size_t /*lane*/) const { return shared; }
    };

    /// The level of each pixel.
    struct Levels {
        std::array<const Plane*, laneCount> planes;
        Floats width;
        Floats height;
        Ints rowLength;

        Levels(const FastSampler& sampler, Ints steps) {
            const Plane* first = sampler.planes.data() + steps[0];
            if (all(steps == ints(steps[0]))) {
                planes.fill(first);
                width = floats(first->fWidth);
                height = floats(first->fHeight);
                rowLength = ints(first->width);
                return;
            }
            for (int i = 0; i < laneCount; ++i) {
                const Plane* plane = sampler.planes.data() + steps[i];
                planes[static_cast<std::size_t>(i)] = plane;
                width[i] = plane->fWidth;
                height[i] = plane->fHeight;
                rowLength[i] = plane->width;
            }
        }

        [[nodiscard]] const Plane& of(std::size_t lane) const { return *planes[lane]; }
    };

    /// Four texels of each pixel: where they lie in their level, and their shares.
    struct Corners {
        std::array<Ints, 4> places;
        std::array<Floats, 4> shares;

        template<class Of>
        Corners(const Of& levels, const TexelPairs& i, const TexelPairs& j)
            : places{j.first * levels.rowLength + i.first, j.first * levels.rowLength + i.second,
                     j.second * levels.rowLength + i.first, j.second * levels.rowLength + i.second}
            , shares{(1.0F - i.share) * (1.0F - j.share), i.share * (1.0F - j.share),
                     (1.0F - i.share) * j.share, i.share * j.share} {}
    };

    /// Where a texel of each pixel lies in its level, in memory: registers are slow to take numbers from one
    /// at a time.
    class Places {
    public:
        explicit Places(Ints indices) { store(indices, indices_.data()); }
        template<class Of>
        Places(const Of& levels, Ints i, Ints j)
            : Places(axes > 1 ? j * levels.rowLength + i : i) {}

        template<class Of>
        [[nodiscard]] Color operator()(const Of& levels, std::size_t lane) const {
            return loadColor(levels.of(lane).texels + indices_[lane]);
        }

    private:
        std::array<std::int32_t, laneCount> indices_;
    };

    /// levelOfDetail() and chooseLevels() of lod.h.
    struct Choice {
        Ints first;
        Ints second;
        Floats share;
        Ints linear;
        Floats probes;
        Floats alongS; ///< the axis of the probes
        Floats alongT;
    };

    /// How far a place moves, in texels of the base level: the squares of both lengths.
    struct Footprint {
        Floats squareX;
        Floats squareY;
    };

    [[nodiscard]] Footprint footprintOf(const Place& place) const {
        const Plane& base = sampler_.planes[0];
        const auto square = [&](Floats s, Floats t) {
            const Floats x = s * base.fWidth;
            if (axes == 1)
                return x * x;
            const Floats y = t * base.fHeight;
            return x * x + y * y;
        };
        return {square(place.dsdx, place.dtdx), square(place.dsdy, place.dtdy)};
    }

    /// Whether a square is too large for a float, undefined, or so small that the number of probes would
    /// suffer. Without probes it's magnified then, whatever its digits.
    [[nodiscard]] bool leavesFloats(const Footprint& footprint, const Place& place) const {
        Ints leaves = ~(footprint.squareX + footprint.squareY <= std::numeric_limits<float>::max());
        if (sampler_.maxProbes > 1)
            leaves |= vanishes(footprint.squareX, place.dsdx, place.dtdx) |
                      vanishes(footprint.squareY, place.dsdy, place.dtdy);
        return any(leaves);
    }
    [[nodiscard]] static Ints vanishes(Floats square, Floats s, Floats t) {
        return (square < std::numeric_limits<float>::min()) & ((s != 0.0F) | (t != 0.0F));
    }

    /// Equation 3.21's rho, or an end of what section 3.8.8 allows for it.
    [[nodiscard]] Floats rhoOf(const Footprint& footprint, const Place& place) const {
        if (sampler_.options.rho == RhoMethod::Ideal)
            return rooted(greater(footprint.squareX, footprint.squareY));
        const Plane& base = sampler_.planes[0];
        const Floats u = greater(magnitude(place.dsdx * base.fWidth), magnitude(place.dsdy * base.fWidth));
        if (axes == 1)
            return u;
        const Floats v = greater(magnitude(place.dtdx * base.fHeight), magnitude(place.dtdy * base.fHeight));
        return sampler_.options.rho == RhoMethod::Lower ? greater(u, v) : u + v;
    }

    [[nodiscard]] Choice choose(const Footprint& footprint, const Place& place) const {
        Choice choice;
        choice.probes = floats(1);
        Floats rho;
        if (sampler_.maxProbes > 1) {
            const Floats x = rooted(footprint.squareX);
            const Floats y = rooted(footprint.squareY);
            const Floats longer = greater(x, y);
            const Floats ratio = longer > 0.0F ? longer / lesser(x, y) : floats(1);
            const Floats probes = -flooredSmall(-lesser(ratio, floats(sampler_.maxProbes)));
            choice.probes = greater(probes, floats(1));
            choice.alongS = x > y ? place.dsdx : place.dsdy;
            choice.alongT = x > y ? place.dtdx : place.dtdy;
            rho = longer / choice.probes;
        } else {
            choice.alongS = choice.alongT = floats(0);
            rho = rhoOf(footprint, place);
        }

        const Floats biased = logarithms2(rho) + sampler_.bias;
        const Floats lambda = lesser(floats(texture_.maxLod), greater(floats(texture_.minLod), biased));
        const Ints minified = lambda > sampler_.switchOver;
        const Ints magLinear = ints(texture_.magFilter == MagFilter::Linear ? -1 : 0);
        const Ints minLinear = ints(isLinear(texture_.minFilter) ? -1 : 0);
        choice.linear = (minified & minLinear) | (~minified & magLinear);
        choice.first = choice.second = ints(0);
        choice.share = floats(0);
        if (!wantsMipmaps(texture_.minFilter))
            return choice;
        const Floats last = floats(sampler_.lastStep);
        if (blendsLevels(texture_.minFilter)) {
            const Floats bounded = minified ? lesser(lambda, last) : floats(0);
            const Floats whole = flooredSmall(bounded);
            choice.share = bounded - whole;
            choice.first = truncated(whole);
            choice.second = choice.first - (choice.share > 0.0F);
        } else {
            const Floats rounded = -flooredSmall(0.5F - lesser(lambda, last + 1.0F));
            choice.first = truncated((minified & (lambda > 0.5F)) ? lesser(rounded, last) : floats(0));
            choice.second = choice.first;
        }
        return choice;
    }

    /// NEAREST: tau_ij.
    template<class Of>
    [[nodiscard]] Colors nearest(const Of& levels, Floats s, Floats t) const {
        const Ints i = nearestTexels(texture_.wrapS, wrapped(texture_.wrapS, s, levels.width), levels.width);
        const Ints j =
            axes > 1 ? nearestTexels(texture_.wrapT, wrapped(texture_.wrapT, t, levels.height), levels.height)
                     : ints(0);
        Colors colors;
        if (usesBorder_) {
            forEachLane([&](std::size_t lane) __attribute__((always_inline)) {
                colors[lane] = texelOrBorder(levels.of(lane), i[lane], j[lane]);
            });
        } else {
            const Places places(levels, i, j);
            forEachLane([&](std::size_t lane)
                            __attribute__((always_inline)) { colors[lane] = places(levels, lane); });
        }
        return colors;
    }

    /// LINEAR at the base level, without a border. First where all texels lie, then what they are: so memory
    /// is asked for many of them at a time.
    template<class Texel>
    void weighBase(const OneLevel& base, const Texel* texels, const SampleRow& row, int count,
                   glm::vec4* colors) const {
        std::array<std::array<std::int32_t, SampleRow::capacity>, 4> places;
        std::array<SampleRow::Numbers, 4> shares;
        for (int at = 0; at < count; at += laneCount) {
            const Floats u = wrapped(texture_.wrapS, load(row.s.data() + at), base.width);
            const Floats v = wrapped(texture_.wrapT, load(row.t.data() + at), base.height);
            const Corners corners(base, {texture_.wrapS, u, base.width}, {texture_.wrapT, v, base.height});
            for (std::size_t corner = 0; corner < 4; ++corner) {
                store(corners.places[corner], places[corner].data() + at);
                store(corners.shares[corner], shares[corner].data() + at);
            }
        }
        for (int at = 0; at < count; at += laneCount) {
            for (std::size_t first = 0; first < laneCount; first += colorsAtOnce) {
                const std::size_t from = static_cast<std::size_t>(at) + first;
                const auto weighted = [&](std::size_t corner) __attribute__((always_inline)) {
                    return spreadFrom(shares[corner].data() + from) *
                           texelsAt(texels, places[corner].data() + from);
                };
                store(weighted(0) + weighted(1) + weighted(2) + weighted(3), colors + from);
            }
        }
    }

    /// LINEAR: equations 3.23 and 3.24.
    template<class Of>
    [[nodiscard, gnu::always_inline]] Colors linearly(const Of& levels, Floats s, Floats t) const {
        const Wrap wrapS = texture_.wrapS;
        const TexelPairs i(wrapS, wrapped(wrapS, s, levels.width), levels.width);
        Colors colors;
        if constexpr (axes == 1) {
            const Floats firstShare = 1.0F - i.share;
            forEachLane([&](std::size_t lane) __attribute__((always_inline)) {
                const Plane& plane = levels.of(lane);
                colors[lane] = firstShare[lane] * texelOrBorder(plane, i.first[lane], 0) +
                               i.share[lane] * texelOrBorder(plane, i.second[lane], 0);
            });
            return colors;
        }
        const Wrap wrapT = texture_.wrapT;
        const TexelPairs j(wrapT, wrapped(wrapT, t, levels.height), levels.height);
        const Corners corners(levels, i, j);
        const std::array<Floats, 4>& shares = corners.shares;
        if (usesBorder_) {
            forEachLane([&](std::size_t lane) __attribute__((always_inline)) {
                const Plane& plane = levels.of(lane);
                colors[lane] = shares[0][lane] * texelOrBorder(plane, i.first[lane], j.first[lane]) +
                               shares[1][lane] * texelOrBorder(plane, i.second[lane], j.first[lane]) +
                               shares[2][lane] * texelOrBorder(plane, i.first[lane], j.second[lane]) +
                               shares[3][lane] * texelOrBorder(plane, i.second[lane], j.second[lane]);
            });
            return colors;
        }
        const Places at00(corners.places[0]);
        const Places at10(corners.places[1]);
        const Places at01(corners.places[2]);
        const Places at11(corners.places[3]);
        const auto weighted = [&](Floats share, const Places& places, std::size_t first)
            __attribute__((always_inline)) {
            return spread(share, first) *
                   joined([&](std::size_t lane) { return places(levels, first + lane); });
        };
        for (std::size_t first = 0; first < laneCount; first += colorsAtOnce)
            store(weighted(shares[0], at00, first) + weighted(shares[1], at10, first) +
                      weighted(shares[2], at01, first) + weighted(shares[3], at11, first),
                  colors.data() + first);
        return colors;
    }

    [[nodiscard]] Colors atLevel(Ints steps, Ints linear, Floats s, Floats t) const {
        const Levels levels(sampler_, steps);
        if (!any(linear))
            return nearest(levels, s, t);
        Colors colors = linearly(levels, s, t);
        if (all(linear))
            return colors;
        const Colors rough = nearest(levels, s, t);
        forEachLane([&](std::size_t lane) __attribute__((always_inline)) {
            colors[lane] = linear[lane] ? colors[lane] : rough[lane];
        });
        return colors;
    }

    /// One level, or two blended: equation 3.28.
    [[nodiscard]] Colors filtered(const Choice& choice, Floats s, Floats t) const {
        Colors colors = atLevel(choice.first, choice.linear, s, t);
        if (any(choice.share > 0.0F)) {
            const Colors second = atLevel(choice.second, choice.linear, s, t);
            const Floats firstShare = 1.0F - choice.share;
            forEachLane([&](std::size_t lane) __attribute__((always_inline)) {
                colors[lane] = firstShare[lane] * colors[lane] + choice.share[lane] * second[lane];
            });
        }
        return colors;
    }

    /// EXT_texture_filter_anisotropic, as sampler.cpp.
    [[nodiscard, gnu::noinline]] Colors probed(const Choice& choice, const Place& place) const {
        const Floats n = choice.probes;
        float most = 1;
        forEachLane([&](std::size_t lane) __attribute__((always_inline)) { most = std::max(most, n[lane]); });
        Colors sum{};
        for (float i = 1; i <= most; ++i) { // NOLINT(clang-analyzer-security.FloatLoopCounter): 16 at most
            const Floats offset = i / (n + 1.0F) - 0.5F;
            const Ints several = n > 1.0F;
            const Floats s = several ? place.s + choice.alongS * offset : place.s;
            const Floats t = several ? place.t + choice.alongT * offset : place.t;
            const Colors colors = filtered(choice, s, t);
            const Ints counts = n >= i;
            forEachLane([&](std::size_t lane) __attribute__((always_inline)) {
                sum[lane] +=
                    reinterpret_cast<Color>(reinterpret_cast<ColorBits>(colors[lane]) & counts[lane]);
            });
        }
        forEachLane([&](std::size_t lane) __attribute__((always_inline)) { sum[lane] /= n[lane]; });
        return sum;
    }

    [[nodiscard]] static Color texel(const Plane& plane, int i, int j) {
        return loadColor(plane.texels + static_cast<std::ptrdiff_t>(j) * plane.width + i);
    }
    [[nodiscard]] Color texelOrBorder(const Plane& plane, int i, int j) const {
        return i < 0 || j < 0 || i >= plane.width || j >= plane.height ? border_ : texel(plane, i, j);
    }

    static void write(const Colors& from, glm::vec4* to) { std::memcpy(to, from.data(), sizeof from); }

    const FastSampler& sampler_;
    const SampledTexture& texture_;
    Color border_;
    bool usesBorder_;
};

/// sample() of sampler.h, for a row. Room for as many colours as there are places, rounded up to a multiple
/// of laneCount.
void sampleRow(const FastSampler& sampler, const SampleRow& row, int count, glm::vec4* colors) {
    switch (sampler.kind) {
    case FastSampler::Kind::Literal:
        return sampleLiterally(sampler, row, 0, count, colors);
    case FastSampler::Kind::BaseOfOneAxis:
        return Pixels<1>(sampler).sampleBase(row, count, colors);
    case FastSampler::Kind::BaseOfTwoAxes:
        return Pixels<2>(sampler).sampleBase(row, count, colors);
    case FastSampler::Kind::LevelsOfOneAxis:
        return Pixels<1>(sampler).sample(row, count, colors);
    case FastSampler::Kind::LevelsOfTwoAxes:
        return Pixels<2>(sampler).sample(row, count, colors);
    }
}
