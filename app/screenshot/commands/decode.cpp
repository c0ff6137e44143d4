#include "app/screenshot/arguments/image_files.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/commands/all_commands.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <algorithm>

namespace texplorer::screenshot {
namespace {

constexpr ImageFormats decodeFormats{
    .only = {},
    .start = "PNG",
    .named = false,
    .lossy = "Use the first of several layers, faces or slices if none is selected, and 8 bits of components "
             "with more. Else such a file is refused; losses are always reported."};

constexpr int notChosen = -1;

struct DecodeOptions {
    ImageFiles files;
    int level = 0;
    int layer = notChosen;
    int face = notChosen;
    int slice = notChosen;
    bool noFlip = false;
};

tl::unexpected<Error> outOfRange(const std::string& in, std::string_view what, int asked, int count,
                                 std::string_view owner) {
    return fail(ErrorCode::OutOfRange,
                count == 1 ? Sentence("there is no {0} {1}: {2} has {0} 0 alone", what, asked, owner)
                           : Sentence("there is no {0} {1}: {2} has 0 to {3}", what, asked, owner, count - 1),
                inFile(inputName(in)));
}

/// A part that can be chosen, its number 0 where it isn't: then the others are lost.
struct ChosenPart {
    std::string_view names; ///< "layers"
    int asked;
    int count;
    std::string_view owner;

    [[nodiscard]] int number() const { return std::max(0, asked); }
    [[nodiscard]] std::string_view name() const { return names.substr(0, names.size() - 1); }
};

Result<void> choose(const std::string& in, const ChosenPart& part, std::vector<Loss>& losses) {
    if (part.number() >= part.count)
        return outOfRange(in, part.name(), part.number(), part.count, part.owner);
    if (part.asked == notChosen && part.count > 1)
        losses.push_back({part.names, Sentence("{0} of its {1} {2} (--{3} chooses one)", part.count - 1,
                                               part.count, part.names, part.name())});
    return {};
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
Result<Image> levelOf(const std::string& in, const TextureImage& texture, int face,
                      const DecodeOptions& options) {
    if (options.level < texture.levels)
        return toImage(texture.surface(face, options.level));
    const Surface& base = texture.surface(face, 0);
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
    std::vector<Loss> losses;
    const ChosenPart layer{"layers", options.layer, texture.layers, "the file"};
    const ChosenPart face{"faces", options.face, texture.faces, "the file"};
    for (const ChosenPart& part : {layer, face})
        if (const Result<void> made = choose(in, part, losses); !made)
            return fail(made.error());
    Result<Image> image = levelOf(in, texture, layer.number() * texture.faces + face.number(), options);
    if (!image)
        return fail(image.error());
    const ChosenPart slice{"slices", options.slice, image->depth, "this level"};
    if (const Result<void> made = choose(in, slice, losses); !made)
        return fail(made.error());
    Image picture = sliceOf(*std::move(image), slice.number());
    // Unflipped, the file's first row is at the bottom, as in a loader that hands its bytes to glTexImage2D.
    const bool isTopFirst = texture.topFirst;
    const bool shouldBeTopFirst = options.noFlip && texture.fileTopFirst;
    if (isTopFirst != shouldBeTopFirst)
        flipVertically(picture);
    // What the file says of its pixels holds for a part of them.
    TextureImage part = textureOf(std::move(picture), texture.format);
    part.srgb = texture.srgb;
    part.alpha = texture.alpha;
    part.componentBits = texture.componentBits;
    part.losses = texture.losses;
    part.parts = texture.parts;
    return MadeImage{.texture = std::move(part), .losses = std::move(losses)};
}

} // namespace

void addDecode(CommandLine& line) {
    Command& command = line.command("decode", "Turn an image file, or a part of it, into a picture.");
    auto options = std::make_shared<DecodeOptions>();
    addImageFiles(command, options->files, decodeFormats, "The image: any format that Texplorer reads",
                  "Print a line for each picture with its input and output.");
    command.number(
        "--level", options->level, 0, 30,
        "The mip level; 0 is the base. If the file has only the base, a box filter makes the levels.");
    command.number("--layer", options->layer, 0, 2047, "The layer of an array, from 0.");
    command.number("--face", options->face, 0, 5,
                   "The face of a cube map: 0 to 5 for +x, -x, +y, -y, +z, -z.");
    command.number("--slice", options->slice, 0, 16383, "The slice of a volume, from 0.");
    command.flag("--no-flip", options->noFlip,
                 "Put the file's first row at the bottom, like a loader that passes its bytes to "
                 "glTexImage2D. Upside down for most formats.");
    command.onCall([options] {
        return makeImages(options->files, decodeFormats,
                          [&](const std::string& in) { return pictureOf(in, *options); });
    });
}

} // namespace texplorer::screenshot
