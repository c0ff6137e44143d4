#include "app/screenshot/arguments/image_files.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/command.h"
#include "core/image/mipmaps.h"
#include "core/s3tc/surface_pixels.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

constexpr ImageFormats decodeFormats{.start = "PNG"};

struct DecodeOptions {
    ImageFiles files;
    int level = 0;
    int face = 0;
    int slice = 0;
    bool noFlip = false;
};

tl::unexpected<Error> outOfRange(const std::string& in, std::string_view what, int asked, int count,
                                 std::string_view owner) {
    return fail(ErrorCode::OutOfRange,
                fmt::format("there is no {} {}: {} has {}{}", what, asked, owner, what,
                            count == 1 ? " 0 alone" : fmt::format("s 0 to {}", count - 1)),
                inputName(in));
}

Image sliceOf(Image volume, int slice) {
    if (volume.depth == 1)
        return volume;
    const std::size_t bytes = volume.pixels.size() / static_cast<std::size_t>(volume.depth);
    Image picture = Image::uninitialised(volume.format, volume.width, volume.height);
    const auto first =
        volume.pixels.begin() + static_cast<std::ptrdiff_t>(bytes * static_cast<std::size_t>(slice));
    std::copy_n(first, bytes, picture.pixels.begin());
    return picture;
}

/// The level that the file holds, or where it holds the base alone, the box-filtered one.
Result<Image> levelOf(const std::string& in, const TextureImage& texture, const DecodeOptions& options) {
    if (options.level < texture.levels)
        return toImage(texture.surface(options.face, options.level));
    const Surface& base = texture.surface(options.face, 0);
    const int chain = mipLevelCount(widthOf(base), heightOf(base), depthOf(base));
    if (texture.levels > 1 || options.level >= chain)
        return outOfRange(in, "level", options.level, texture.levels > 1 ? texture.levels : chain,
                          texture.levels > 1 ? "the file" : "its full chain");
    return std::move(buildMipChain(toImage(base))[static_cast<std::size_t>(options.level)]);
}

Result<MadeImage> pictureOf(const std::string& in, const DecodeOptions& options) {
    const Result<TextureImage> decoded = readTexture(in);
    if (!decoded)
        return fail(decoded.error());
    const TextureImage& texture = *decoded;
    if (options.face >= texture.faces)
        return outOfRange(in, "face", options.face, texture.faces, "the file");
    Result<Image> image = levelOf(in, texture, options);
    if (!image)
        return fail(image.error());
    if (options.slice >= image->depth)
        return outOfRange(in, "slice", options.slice, image->depth, "this level");
    Image picture = sliceOf(*std::move(image), options.slice);
    // Unflipped, the file's first row is at the bottom, as in a loader that hands its bytes to glTexImage2D.
    const bool isTopFirst = texture.topFirst;
    const bool shouldBeTopFirst = options.noFlip && texture.fileTopFirst;
    if (isTopFirst != shouldBeTopFirst)
        flipVertically(picture);
    return MadeImage{textureOf(std::move(picture), texture.format)};
}

} // namespace

void addDecode(CommandLine& line) {
    Command& command = line.command("decode", "Turn an image file, or a part of it, into a picture.");
    auto options = std::make_shared<DecodeOptions>();
    addImageFiles(command, options->files, decodeFormats, "The image: any format that Texplorer reads",
                  "Print a line for each picture: what became of what.");
    command.number(
        "--level", options->level, 0, 30,
        "Which mip level, 0 the base. A file that holds only the base gets its levels from a box filter.");
    command.number("--face", options->face, 0, 5,
                   "Which face of a cube map: 0 to 5 for +x, -x, +y, -y, +z, -z.");
    command.number("--slice", options->slice, 0, 16383, "Which slice of a volume, 0 the first.");
    command.flag("--no-flip", options->noFlip,
                 "Put the file's first row at the bottom, as a loader does that hands its bytes to "
                 "glTexImage2D: upside down for most formats.");
    command.onCall([options] {
        return makeImages(options->files, decodeFormats,
                          [&](const std::string& in) { return pictureOf(in, *options); });
    });
}

} // namespace texplorer::screenshot
