// What of a block goes together.

#include "texplorer/s3tc/block_parts.h"

namespace texplorer {
namespace {

using Kind = BlockMark::Kind;

/// Which ends a colour is made of: those with the indices 0 and 1 are one each, and black is made of none.
std::array<bool, 2> endsOfColor(std::size_t index, bool fourColors) {
    const bool both = index == 2 || (index == 3 && fourColors);
    return {index == 0 || both, index == 1 || both};
}

/// The same for the alphas of DXT5: without eight of them the last two are 0 and 255.
std::array<bool, 2> endsOfAlpha(std::size_t index, bool eightAlphas) {
    const bool both = index >= 2 && (index < 6 || eightAlphas);
    return {index == 0 || both, index == 1 || both};
}

/// Collects what goes together, from a set of texels, colours and alphas on.
class LinkFinder {
public:
    LinkFinder(BlockFormat format, const BlockFields& fields)
        : format_(format)
        , fields_(fields) {}

    void texel(std::size_t number) {
        links_.texels.set(number);
        if (alphaCount(format_) > 0)
            alphaOf(number);
        colorOf(number);
    }
    void colorOf(std::size_t texel) {
        links_.texels.set(texel);
        links_.colors.set(fields_.indices[texel]);
        light(BlockPart::ColorIndex, texel);
    }
    void alphaOf(std::size_t texel) {
        links_.texels.set(texel);
        links_.alphas.set(fields_.alphas[texel]);
        light(BlockPart::Alpha, texel);
    }
    void color(std::size_t index) {
        links_.colors.set(index);
        lightEnds(BlockPart::Color, endsOfColor(index, hasFourColors(format_, fields_)));
        for (std::size_t texel = 0; texel < 16; ++texel)
            if (fields_.indices[texel] == index)
                colorOf(texel);
    }
    void alpha(std::size_t index) {
        links_.alphas.set(index);
        if (format_ == BlockFormat::Dxt5)
            lightEnds(BlockPart::AlphaEnd, endsOfAlpha(index, hasEightAlphas(fields_)));
        for (std::size_t texel = 0; texel < 16; ++texel)
            if (fields_.alphas[texel] == index)
                alphaOf(texel);
    }
    /// An end goes with all that is made of it.
    void colorEnd(std::size_t end) {
        light(BlockPart::Color, end);
        for (std::size_t index = 0; index < 4; ++index)
            if (endsOfColor(index, hasFourColors(format_, fields_))[end])
                madeOfEnd(links_.colors, index, fields_.indices);
    }
    void alphaEnd(std::size_t end) {
        light(BlockPart::AlphaEnd, end);
        for (std::size_t index = 0; index < alphaCount(format_); ++index)
            if (endsOfAlpha(index, hasEightAlphas(fields_))[end])
                madeOfEnd(links_.alphas, index, fields_.alphas);
    }
    [[nodiscard]] const BlockLinks& links() const { return links_; }

private:
    void light(BlockPart part, std::size_t number) {
        const BlockField& field = blockField(format_, part, static_cast<int>(number));
        links_.fields.set(fieldAtBit(format_, field.first));
    }
    void lightEnds(BlockPart part, std::array<bool, 2> ends) {
        for (std::size_t end = 0; end < 2; ++end)
            if (ends[end])
                light(part, end);
    }
    template<std::size_t count>
    void madeOfEnd(std::bitset<count>& entries, std::size_t index, const std::array<std::uint8_t, 16>& of) {
        entries.set(index);
        for (std::size_t texel = 0; texel < 16; ++texel)
            if (of[texel] == index)
                links_.texels.set(texel);
    }

    BlockFormat format_;
    const BlockFields& fields_;
    BlockLinks links_;
};

} // namespace

BlockLinks linksOf(BlockFormat format, const BlockFields& fields, const BlockMark& mark) {
    LinkFinder finder(format, fields);
    switch (mark.kind) {
    case Kind::Texel:
        finder.texel(mark.number);
        break;
    case Kind::Color:
        finder.color(mark.number);
        break;
    case Kind::Alpha:
        finder.alpha(mark.number);
        break;
    case Kind::Field: {
        const BlockField& field = blockFields(format)[mark.number];
        const auto number = static_cast<std::size_t>(field.number);
        switch (field.part) {
        case BlockPart::Color:
            finder.colorEnd(number);
            break;
        case BlockPart::ColorIndex:
            finder.colorOf(number);
            break;
        case BlockPart::AlphaEnd:
            finder.alphaEnd(number);
            break;
        case BlockPart::Alpha:
            finder.alphaOf(number);
            break;
        }
    }
    }
    return finder.links();
}

} // namespace texplorer
