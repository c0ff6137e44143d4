#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/image_files.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/prepare_argument.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/long_work.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/losses.h"
#include "texplorer/image/cube_faces.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/texture/texture_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <optional>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr ImageFormats compressFormats{.only = "DDS"};

struct CompressOptions {
    ImageFiles files;
    std::string format;
    std::string quality = std::string(rowOf(EncodeQuality::Normal).name);
    std::string mips; ///< empty: the file's levels, and where it holds the base alone, those of a box filter
    bool gamma = false;
    bool powerOfTwo = false;
    bool cube = false;
    PrepareArgument prepare;
    std::string coverage;
};

/// The formats that can be written, by the names that DirectX gave them.
constexpr std::array formats{
    row(BlockFormat::Dxt1, "dxt1", {}, {}), row(BlockFormat::Dxt1Alpha, "dxt1a", {}, {}),
    row(BlockFormat::Dxt3, "dxt3", {}, {}), row(BlockFormat::Dxt5, "dxt5", {}, {}),
    row(BlockFormat::Bc4, "bc4", {}, {}),   row(BlockFormat::Bc5, "bc5", {}, {}),
};

/// The names that others gave them: Direct3D 10, ATI and OpenGL's extensions.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> otherNames{{{"bc1", "dxt1"},
                                                                                   {"bc1a", "dxt1a"},
                                                                                   {"bc2", "dxt3"},
                                                                                   {"bc3", "dxt5"},
                                                                                   {"ati1", "bc4"},
                                                                                   {"ati2", "bc5"},
                                                                                   {"rgtc1", "bc4"},
                                                                                   {"rgtc2", "bc5"}}};

const EnumRow* formatNamed(std::string_view name) {
    for (const auto& [other, format] : otherNames)
        if (isSameName(name, other))
            return findRow(formats, format);
    return findChoice(formats, name);
}

std::vector<std::string> formatChoices() {
    std::vector<std::string> names = namesIn(formats);
    for (const auto& [other, format] : otherNames)
        names.emplace_back(other);
    return names;
}

/// What --mips accepts: every filter, and none.
constexpr std::string_view noMips = "none";
std::string mipNames() {
    return fmt::format("{}, {}", noMips, listNames(mipFilterRows));
}

std::vector<std::string> mipChoices() {
    std::vector<std::string> names = namesIn(mipFilterRows);
    names.insert(names.begin(), std::string(noMips));
    return names;
}

/// The options as what they name.
struct Choices {
    BlockFormat format = BlockFormat::Dxt1;
    EncodeQuality quality = EncodeQuality::Normal;
    std::optional<MipFilter> mips = MipFilter::Box;
    bool keepsLevels = true; ///< those that a file has
    std::vector<ImageStep> steps;
    float coverage = 0; ///< 0: as it becomes
};

/// An alpha test's reference.
Result<float> coverageOf(const std::string& text) {
    const Result<Value> value =
        parseValue(*findParam(textureTable(), keyOf<&Texture::mipCoverage>()), text.empty() ? "0" : text);
    if (!value)
        return fail(value.error().code, value.error().message, atOption("--coverage"));
    return std::get<float>(*value);
}

Result<Choices> choicesOf(const CompressOptions& options) {
    Choices choices;
    const EnumRow* format = formatNamed(options.format);
    if (!format)
        return refuseChoice(formatChoices(), options.format, "--format");
    choices.format = static_cast<BlockFormat>(format->value);
    const Result<EncodeQuality> quality = parseChoice<EncodeQuality>(options.quality, "--quality");
    if (!quality)
        return fail(quality.error());
    choices.quality = *quality;
    Result<std::vector<ImageStep>> steps = stepsOf(options.prepare);
    if (!steps)
        return fail(steps.error());
    choices.steps = *std::move(steps);
    const Result<float> coverage = coverageOf(options.coverage);
    if (!coverage)
        return fail(coverage.error());
    choices.coverage = *coverage;
    choices.keepsLevels = options.mips.empty();
    if (choices.keepsLevels)
        return choices;
    choices.mips.reset();
    if (isSameName(options.mips, noMips))
        return choices;
    const EnumRow* filter = findChoice(mipFilterRows, options.mips);
    if (!filter)
        return refuseChoice(mipChoices(), options.mips, "--mips");
    choices.mips = static_cast<MipFilter>(filter->value);
    return choices;
}

/// Whether the file's levels are compressed as they are. Faces that are cut out have none, nor has what is
/// scaled.
bool keepsLevels(const TextureImage& texture, const CompressOptions& options, const Choices& choices) {
    const auto isPowerOfTwo = [](int extent) { return std::has_single_bit(static_cast<unsigned>(extent)); };
    const Surface& base = texture.surface(0, 0);
    const bool isCut = options.cube && texture.faces == 1;
    const bool isScaled =
        options.powerOfTwo && !(isPowerOfTwo(widthOf(base)) && isPowerOfTwo(heightOf(base)));
    const bool isResized =
        std::ranges::find(choices.steps, ImageOp::Resize, &ImageStep::op) != choices.steps.end();
    return texture.levels > 1 && choices.keepsLevels && !isCut && !isScaled && !isResized;
}

/// What becomes of levels that are not kept.
Loss levelsLost(int levels, const Choices& choices) {
    return {"levels",
            choices.mips ? Sentence("{0} of its {1} mip levels (generated from the base)", levels - 1, levels)
                         : Sentence("{0} of its {1} mip levels", levels - 1, levels)};
}

/// The pictures to compress, bottom row first, the levels of a face together: of one picture, or of the six
/// faces of a cube map; their bases alone without `allLevels`.
Result<std::vector<MipChain>> picturesOf(TextureImage texture, const CompressOptions& options, bool allLevels,
                                         const std::string& in) {
    const auto refused = [&](const std::string& message) {
        return fail(ErrorCode::Unsupported, message, inFile(inputName(in)));
    };
    const Surface& base = texture.surface(0, 0);
    if (texture.layers != 1)
        return refused(
            fmt::format("expected a picture or a cube map, found an array of {}; texshot decode extracts "
                        "one layer",
                        Sentence::plural("{0} layer", "{0} layers", texture.layers)));
    if (depthOf(base) != 1)
        return refused(
            fmt::format("expected a picture or a cube map, found a volume of {} slices", depthOf(base)));
    std::vector<MipChain> pictures;
    if (texture.faces == 1 && options.cube) { // cubeFace takes and gives them with the top row first
        if (cubeLayout(widthOf(base), heightOf(base)) == CubeLayout::Same)
            return refused(fmt::format(
                "expected the faces of a cube map in a picture of 6:1, 1:6, 4:3 or 3:4, found {} × {}",
                widthOf(base), heightOf(base)));
        Image picture = uprightImage(std::move(texture));
        flipVertically(picture);
        for (int face = 0; face < cubeFaceCount; ++face)
            flipVertically(pictures.emplace_back(MipChain{cubeFace(picture, face)}).front());
        return pictures;
    }
    for (int face = 0; face < texture.faces; ++face) {
        MipChain& levels = pictures.emplace_back();
        for (int level = 0; level < (allLevels ? texture.levels : 1); ++level) {
            Image& picture = levels.emplace_back(toImage(texture.surface(face, level)));
            if (texture.topFirst)
                flipVertically(picture);
        }
    }
    return pictures;
}

/// The levels to compress, in the order in which a DDS file stores rows.
MipChain levelsOf(MipChain file, const Choices& choices, const CompressOptions& options) {
    const MipOptions how{choices.mips.value_or(MipFilter::Box), options.gamma,
                         options.powerOfTwo ? NpotPolicy::PowerOfTwo : NpotPolicy::Keep, choices.coverage};
    for (std::size_t level = 0; level < file.size(); ++level)
        file[level] = preparedBy(choices.steps, std::move(file[level]), static_cast<int>(level));
    MipChain chain = file.size() > 1 ? std::move(file)
                                     : applyMipPolicy(choices.mips ? MipPolicy::Generated : MipPolicy::None,
                                                      std::move(file.front()), how);
    for (Image& level : chain)
        flipVertically(level);
    return chain;
}

TextureReport reportOf(const TextureImage& texture, const MipChain& source) {
    std::vector<TextureLevel> levels;
    for (const Surface& surface : texture.surfaces) {
        const auto count = static_cast<int>(levels.size());
        levels.push_back({count % texture.levels, surface, count / texture.levels});
    }
    return reportOn(levels, source);
}

Result<MadeImage> compressFile(const std::string& in, const CompressOptions& options,
                               const Choices& choices) {
    Result<TextureImage> file = readTexture(in);
    if (!file)
        return fail(file.error());
    std::vector<Loss> losses = lossesIn(*file, "DDS");
    if (options.prepare.premultiply && file->alpha == AlphaMeaning::Premultiplied)
        return fail(ErrorCode::Unsupported, "its colours are already multiplied by alpha",
                    atOption("--premultiply"));
    const bool isPremultiplied = options.prepare.premultiply || file->alpha == AlphaMeaning::Premultiplied;
    const bool keeps = keepsLevels(*file, options, choices);
    if (file->levels > 1 && !keeps)
        losses.push_back(levelsLost(file->levels, choices));
    constexpr const char* kept = "it applies only to generated mip levels, but those of the file are kept";
    if (keeps && options.gamma)
        noteUnused("--gamma", kept);
    if (keeps && choices.coverage > 0)
        noteUnused("--coverage", kept);
    else if (choices.coverage > 0 && file->alpha == AlphaMeaning::None && choices.steps.empty())
        noteUnused("--coverage", "the picture has no alpha");
    Result<std::vector<MipChain>> pictures = picturesOf(*std::move(file), options, keeps, in);
    if (!pictures)
        return fail(pictures.error());
    MipChain source; // of one face after the other
    for (MipChain& picture : *pictures)
        std::ranges::move(levelsOf(std::move(picture), choices, options), std::back_inserter(source));
    std::ranges::move(lossesIn(source, choices.format), std::back_inserter(losses));

    LongWork work("texshot: compressing");
    auto blocks = encodeLevels(
        source, choices.format, choices.quality, [&work](float done) { work.report(done); },
        work.stopToken());
    work.finish();
    if (work.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled, "compressing was stopped");
    if (!blocks)
        return fail(blocks.error().code, blocks.error().message, inFile(inputName(in)));

    TextureImage texture;
    texture.format = "DDS";
    texture.faces = static_cast<int>(pictures->size());
    texture.levels = static_cast<int>(blocks->size()) / texture.faces;
    texture.topFirst = true; // as DDS stores it
    texture.alpha = isPremultiplied ? AlphaMeaning::Premultiplied : AlphaMeaning::Straight;
    for (BlockImage& level : *blocks)
        texture.surfaces.emplace_back(std::move(level));
    MadeImage made{.texture = std::move(texture), .losses = std::move(losses)};
    if (options.files.report || options.files.json)
        made.report = reportOf(made.texture, source);
    return made;
}

ExitCode run(const CompressOptions& options) {
    const Result<Choices> choices = choicesOf(options);
    if (!choices)
        return complain(choices.error(), wrongCall);
    if (options.gamma && !choices->mips && !options.powerOfTwo)
        noteUnused("--gamma", "it applies only to mip levels and --power-of-two, but there is neither");
    if (choices->coverage > 0 && keptComponents(choices->format) < 4)
        noteUnused("--coverage", fmt::format("{} has no alpha", rowOf(choices->format).label));
    else if (choices->coverage > 0 && !choices->mips && !choices->keepsLevels)
        noteUnused("--coverage", "it applies only to mip levels, and there are none");
    return makeImages(options.files, compressFormats,
                      [&](const std::string& in) { return compressFile(in, options, *choices); });
}

} // namespace

void addCompress(CommandLine& line) {
    Command& command =
        line.command("compress", "Compress a picture or a cube map into a DDS file of S3TC or RGTC blocks.");
    auto options = std::make_shared<CompressOptions>();
    addImageFiles(
        command, options->files, compressFormats, "The picture: any format that Texplorer reads",
        "Print each level's bytes and loss (PSNR against the picture, over the components that the format "
        "keeps and the picture has), and the sum relative to the base level and to uncompressed pixels.");
    command.option(
        "--format", options->format,
        "dxt1, dxt1a (1-bit alpha), dxt3, dxt5, bc4 or bc5; also as bc1, bc1a, bc2, bc3, ati1 or rgtc1, ati2 or "
        "rgtc2.",
        {.value = "FORMAT", .required = true, .offers = {formatChoices}});
    command.option("--quality", options->quality,
                   "fast, normal or best: from tens of megatexels to half a megatexel a second.",
                   {.value = "QUALITY", .offers = {choiceNames<EncodeQuality>}});
    command.option(
        "--mips", options->mips,
        fmt::format(
            "The filter that makes the mip levels, or none: {}. Default: the levels of the file if it has "
            "some, else a box filter.",
            mipNames()),
        {.value = "FILTER", .offers = {mipChoices}});
    command.flag("--gamma", options->gamma,
                 "Average colours as amounts of light, by the sRGB curve: black and white then give 188, "
                 "not 128.");
    command.flag("--power-of-two", options->powerOfTwo,
                 "Scale the picture to the nearest powers of two first, as in gluBuild2DMipmaps.");
    command.flag("--cube", options->cube,
                 "Cut a picture of 6:1, 1:6, 4:3 or 3:4 into the six faces of a cube map. A cube map "
                 "always stays a cube map.");
    addPrepareArgument(command, options->prepare);
    command.option(
        "--coverage", options->coverage,
        "Scale alpha of each mip level so that as much of it as of the picture passes an alpha test "
        "with this reference, from 0 to 1.",
        {.value = "REFERENCE"});
    command.onCall([options] { return run(*options); });
}

} // namespace texplorer::screenshot
