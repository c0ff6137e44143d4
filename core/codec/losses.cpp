#include "texplorer/codec/losses.h"

#include "texplorer/image/convert.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace texplorer {
namespace {

/// The data other than level 0 of face 0, which only DDS can store.
void addParts(const TextureImage& texture, std::vector<Loss>& losses) {
    const int slices = depthOf(texture.surfaces.front());
    if (texture.layers > 1)
        losses.push_back(
            {"layers", Sentence("{0} of the array's {1} layers", texture.layers - 1, texture.layers)});
    if (texture.faces > 1)
        losses.push_back(
            {"faces", Sentence("{0} of the cube map's {1} faces", texture.faces - 1, texture.faces)});
    if (slices > 1)
        losses.push_back({"slices", Sentence("{0} of the volume's {1} slices", slices - 1, slices)});
    if (texture.levels > 1)
        losses.push_back(
            {"levels", Sentence("{0} of the texture's {1} mip levels", texture.levels - 1, texture.levels)});
}

void addAlpha(const TextureImage& texture, std::string_view format, std::vector<Loss>& losses) {
    const Image* image = std::get_if<Image>(&texture.surfaces.front());
    if (format != "BMP" && image != nullptr && image->format == PixelFormat::Alpha8)
        losses.push_back({"alpha", N_("alpha without colour becomes grey"), false});
    if (format != "TGA" && texture.alpha == AlphaMeaning::Premultiplied)
        losses.push_back({"alpha", N_("the mark that colours are multiplied by alpha"), false});
}

void addFileParts(const TextureImage& texture, std::vector<Loss>& losses) {
    const auto has = [&](std::string_view name) {
        return std::ranges::find(texture.parts, name, &FilePart::name) != texture.parts.end();
    };
    if (has("iCCP"))
        losses.push_back({"colorProfile", N_("the ICC profile"), false});
    else if (!has("sRGB") && (has("gAMA") || has("cHRM")))
        losses.push_back({"colorProfile", N_("its colour space (gAMA, cHRM)"), false});
    if (has("tEXt") || has("zTXt") || has("iTXt"))
        losses.push_back({"metadata", N_("its texts"), false});
    if (has("eXIf"))
        losses.push_back({"metadata", N_("metadata (Exif)"), false});
}

/// "red, green and blue"
Sentence listed(std::span<const std::string_view> words) {
    Sentence text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text = i == 0                  ? Sentence(words[i])
               : i + 1 == words.size() ? Sentence("{0} and {1}", text, words[i])
                                       : Sentence("{0}, {1}", text, words[i]);
    return text;
}

} // namespace

std::vector<Loss> lossesIn(const TextureImage& texture, std::string_view format) {
    std::vector<Loss> losses = texture.losses;
    if (texture.componentBits > 8)
        losses.push_back({"componentBits", Sentence("{0} bits a component become 8", texture.componentBits)});
    if (format != "DDS") {
        addParts(texture, losses);
        addAlpha(texture, format, losses);
    }
    if (format != "PNG")
        addFileParts(texture, losses);
    return losses;
}

std::vector<Loss> lossesIn(const MipChain& pictures, BlockFormat format) {
    constexpr std::array<std::string_view, 4> names{"red", "green", "blue", "alpha"};
    constexpr std::array<int, 4> unsaid{0, 0, 0, 255}; // what is decoded where nothing is kept
    const std::size_t kept = keptComponents(format);
    std::array<bool, 4> saysSomething{};
    bool isGrey = true;
    for (const Image& picture : pictures) {
        const auto step = static_cast<std::size_t>(bytesPerPixel(picture.format));
        for (std::size_t at = 0; kept < names.size() && at < picture.pixels.size(); at += step) {
            const auto rgba = rgbaOf(picture.format, picture.pixels.data() + at);
            isGrey = isGrey && rgba[0] == rgba[1] && rgba[0] == rgba[2];
            for (std::size_t c = kept; c < names.size(); ++c)
                saysSomething[c] = saysSomething[c] || rgba[c] != unsaid[c];
        }
    }
    std::vector<std::string_view> lost;
    for (std::size_t c = kept; c < names.size(); ++c)
        if (saysSomething[c] && !(isGrey && c < 3))
            lost.push_back(names[c]);
    if (lost.empty())
        return {};
    return {{"components", Sentence("{0} ({1} keeps only {2})", listed(lost), ProperName{rowOf(format).label},
                                    listed(std::span(names).first(kept)))}};
}

Sentence allLost(const std::vector<Loss>& losses) {
    std::vector<Sentence> sentences;
    std::ranges::transform(losses, std::back_inserter(sentences), &Loss::sentence);
    return Sentence::joined("{0}; {1}", sentences);
}

Sentence pixelsLost(const std::vector<Loss>& losses) {
    std::vector<Loss> ofPixels;
    std::ranges::copy_if(losses, std::back_inserter(ofPixels), &Loss::ofPixels);
    return allLost(ofPixels);
}

} // namespace texplorer
