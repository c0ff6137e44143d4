#include "core/codec/losses.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer {
namespace {

/// Of what only DDS holds beside level 0 of face 0.
void addParts(const TextureImage& texture, std::vector<Loss>& losses) {
    const int slices = depthOf(texture.surfaces.front());
    if (texture.layers > 1)
        losses.push_back(
            {"layers", fmt::format("{} of the array's {} layers", texture.layers - 1, texture.layers)});
    if (texture.faces > 1)
        losses.push_back(
            {"faces", fmt::format("{} of the cube map's {} faces", texture.faces - 1, texture.faces)});
    if (slices > 1)
        losses.push_back({"slices", fmt::format("{} of the volume's {} slices", slices - 1, slices)});
    if (texture.levels > 1)
        losses.push_back(
            {"levels", fmt::format("{} of the texture's {} mip levels", texture.levels - 1, texture.levels)});
}

void addAlpha(const TextureImage& texture, std::string_view format, std::vector<Loss>& losses) {
    const Image* image = std::get_if<Image>(&texture.surfaces.front());
    if (format != "BMP" && image != nullptr && image->format == PixelFormat::Alpha8)
        losses.push_back({"alpha", "alpha alone becomes grey", false});
    if (format != "TGA" && texture.alpha == AlphaMeaning::Premultiplied)
        losses.push_back({"alpha", "that colours are multiplied by alpha", false});
}

void addFileParts(const TextureImage& texture, std::vector<Loss>& losses) {
    const auto has = [&](std::string_view name) {
        return std::ranges::find(texture.parts, name, &FilePart::name) != texture.parts.end();
    };
    if (has("iCCP"))
        losses.push_back({"colorProfile", "the ICC profile", false});
    else if (!has("sRGB") && (has("gAMA") || has("cHRM")))
        losses.push_back({"colorProfile", "what its numbers mean as colours (gAMA, cHRM)", false});
    if (has("tEXt") || has("zTXt") || has("iTXt"))
        losses.push_back({"metadata", "its texts", false});
    if (has("eXIf"))
        losses.push_back({"metadata", "what the camera or a program noted (Exif)", false});
}

} // namespace

std::vector<Loss> lossesIn(const TextureImage& texture, std::string_view format) {
    std::vector<Loss> losses = texture.losses;
    if (texture.componentBits > 8)
        losses.push_back(
            {"componentBits", fmt::format("{} bits a component become 8", texture.componentBits)});
    if (format != "DDS") {
        addParts(texture, losses);
        addAlpha(texture, format, losses);
    }
    if (format != "PNG")
        addFileParts(texture, losses);
    return losses;
}

std::string pixelsLost(const std::vector<Loss>& losses) {
    std::string text;
    for (const Loss& loss : losses)
        if (loss.ofPixels)
            text.append(text.empty() ? "" : "; ").append(loss.sentence);
    return text;
}

} // namespace texplorer
