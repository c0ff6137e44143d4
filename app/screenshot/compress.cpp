#include "app/screenshot/choice_argument.h"
#include "app/screenshot/command.h"
#include "app/screenshot/interrupts.h"
#include "app/screenshot/long_work.h"
#include "app/screenshot/option_use.h"
#include "app/screenshot/output.h"
#include "app/screenshot/texture_input.h"
#include "core/image/mipmaps.h"
#include "core/s3tc/encode.h"
#include "core/scene/texture_levels.h"

#include <array>
#include <optional>

namespace texplorer::screenshot {
namespace {

struct Options {
    std::string in;
    std::string out;
    std::string format;
    std::string quality = std::string(rowOf(EncodeQuality::Normal).name);
    std::string mips = std::string(rowOf(MipFilter::Box).name);
    bool gamma = false;
    bool powerOfTwo = false;
    bool report = false;
};

/// The formats that can be written, by the names that DirectX gave them.
constexpr std::array formats{
    row(BlockFormat::Dxt1, "dxt1", "", ""), row(BlockFormat::Dxt1Alpha, "dxt1a", "", ""),
    row(BlockFormat::Dxt3, "dxt3", "", ""), row(BlockFormat::Dxt5, "dxt5", "", ""),
    row(BlockFormat::Bc4, "bc4", "", ""),   row(BlockFormat::Bc5, "bc5", "", ""),
};

/// What --mips accepts: every filter, and none.
constexpr std::string_view noMips = "none";
std::string mipNames() {
    return std::string(noMips) + ", " + listNames(mipFilterRows);
}

/// The options as what they name.
struct Choices {
    BlockFormat format = BlockFormat::Dxt1;
    EncodeQuality quality = EncodeQuality::Normal;
    std::optional<MipFilter> mips;
};

Result<Choices> choicesOf(const Options& options) {
    Choices choices;
    const EnumRow* format = findRow(formats, options.format);
    if (!format)
        return refuseChoice(listNames(formats), options.format, "--format");
    choices.format = static_cast<BlockFormat>(format->value);
    const Result<EncodeQuality> quality = parseChoice<EncodeQuality>(options.quality, "--quality");
    if (!quality)
        return fail(quality.error());
    choices.quality = *quality;
    if (options.mips == noMips)
        return choices;
    const EnumRow* filter = findRow(mipFilterRows, options.mips);
    if (!filter)
        return refuseChoice(mipNames(), options.mips, "--mips");
    choices.mips = static_cast<MipFilter>(filter->value);
    return choices;
}

/// The levels to compress, in the order in which a DDS file stores rows.
MipChain levelsOf(Image base, std::optional<MipFilter> mips, const Options& options) {
    const MipOptions how{mips.value_or(MipFilter::Box), options.gamma,
                         options.powerOfTwo ? NpotPolicy::PowerOfTwo : NpotPolicy::Keep};
    MipChain chain = applyMipPolicy(mips ? MipPolicy::Generated : MipPolicy::None, std::move(base), how);
    for (Image& level : chain)
        flipVertically(level);
    return chain;
}

std::string reportOf(const TextureImage& texture, const MipChain& source) {
    std::vector<TextureLevel> levels;
    for (const Surface& surface : texture.surfaces)
        levels.push_back({static_cast<int>(levels.size()), surface});
    return describe(reportOn(levels, source));
}

ExitCode run(const Options& options) {
    const Result<Choices> choices = choicesOf(options);
    if (!choices)
        return complain(choices.error(), wrongCall);
    if (options.gamma && !choices->mips && !options.powerOfTwo)
        return refuseUnused("--gamma", "it is for mip levels and --power-of-two, and there is neither");
    const auto output = openImageOutput(options.out, "DDS", "DDS");
    if (!output)
        return output.error();
    Result<TextureImage> file = readTexture(options.in);
    if (!file)
        return complain(file.error());
    Image base = uprightImage(*std::move(file));
    if (base.depth != 1)
        return complain({ErrorCode::Unsupported,
                         "expected a picture, found a volume of " + std::to_string(base.depth) + " slices",
                         options.in});
    const MipChain source = levelsOf(std::move(base), choices->mips, options);

    LongWork work("texshot: compressing");
    auto blocks = encodeLevels(
        source, choices->format, choices->quality, [&work](float done) { work.report(done); },
        work.stopToken());
    work.finish();
    if (work.stopToken().stop_requested())
        return complainInterrupted();
    if (!blocks)
        return complain({blocks.error().code, blocks.error().message, options.in});

    TextureImage texture;
    texture.format = "DDS";
    texture.levels = static_cast<int>(blocks->size());
    texture.topFirst = true; // as DDS stores it
    texture.alpha = AlphaMeaning::Straight;
    for (BlockImage& level : *blocks)
        texture.surfaces.emplace_back(std::move(level));
    if (const auto written = output->write(texture); !written)
        return complain(written.error());
    if (options.report) {
        if (const auto written = print(reportOf(texture, source)); !written)
            return complain(written.error());
    }
    return success;
}

} // namespace

void addCompress(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("compress", "Compress a picture into a DDS file of S3TC or RGTC blocks.");
    auto options = std::make_shared<Options>();
    command->add_option("IN", options->in, "The picture: any format that Texplorer reads.")->required();
    command->add_option("OUT", options->out, "The DDS file to write; - for standard output.")->required();
    command->add_option("--format", options->format, "dxt1, dxt1a (1-bit alpha), dxt3, dxt5, bc4 or bc5.")
        ->required();
    command->add_option("--quality", options->quality,
                        "fast, normal or best: from tens of megatexels a second to half a one.");
    command->add_option(
        "--mips", options->mips,
        "The filter that makes the mip levels, box unless another is named, or none: " + mipNames() + ".");
    command->add_flag("--gamma", options->gamma,
                      "Average colours as light, by sRGB's curve: black and white then give 188, not 128.");
    command->add_flag("--power-of-two", options->powerOfTwo,
                      "Scale the picture to the nearest powers of two first, as gluBuild2DMipmaps does it.");
    command->add_flag("--report", options->report,
                      "Print each level's bytes and what it lost (PSNR against the picture), and the sum "
                      "against the base level and against uncompressed pixels.");
    command->callback([&action, options] { action = [options] { return run(*options); }; });
}

} // namespace texplorer::screenshot
