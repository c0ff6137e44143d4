#include "app/screenshot/command.h"
#include "app/screenshot/texture_io.h"
#include "core/image/mipmaps.h"
#include "core/s3tc/encode.h"

#include <map>

namespace texplorer::screenshot {
namespace {

constexpr ExitCode interrupted =
    static_cast<ExitCode>(130); // as a shell says it of a program that Ctrl+C ended

struct Options {
    std::string in;
    std::string out;
    BlockFormat format = BlockFormat::Dxt1;
    EncodeQuality quality = EncodeQuality::Normal;
    bool mips = true;
};

const std::map<std::string, BlockFormat> formats{
    {"dxt1", BlockFormat::Dxt1}, {"dxt1a", BlockFormat::Dxt1Alpha}, {"dxt3", BlockFormat::Dxt3},
    {"dxt5", BlockFormat::Dxt5}, {"bc4", BlockFormat::Bc4},         {"bc5", BlockFormat::Bc5},
};

std::map<std::string, EncodeQuality> qualities() {
    std::map<std::string, EncodeQuality> names;
    for (const EnumRow& row : encodeQualityRows)
        names.emplace(row.name, static_cast<EncodeQuality>(row.value));
    return names;
}

Result<TextureImage> compress(Image base, const Options& options, LongWork& work) {
    if (base.depth != 1)
        return fail(ErrorCode::Unsupported,
                    "expected a picture, found a volume of " + std::to_string(base.depth) + " slices");
    MipChain chain;
    if (options.mips)
        chain = buildMipChain(std::move(base));
    else
        chain.push_back(std::move(base));
    std::size_t allPixels = 0;
    for (const Image& level : chain)
        allPixels += static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);

    TextureImage texture;
    texture.format = "DDS";
    texture.levels = static_cast<int>(chain.size());
    texture.topFirst = true; // as DDS stores it
    texture.alpha = AlphaMeaning::Straight;
    std::size_t donePixels = 0;
    for (Image& level : chain) {
        flipVertically(level);
        const std::size_t pixels =
            static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
        const auto progress = [&](float done) {
            work.report((static_cast<float>(donePixels) + done * static_cast<float>(pixels)) /
                        static_cast<float>(allPixels));
        };
        Result<BlockImage> blocks =
            encodeBlocks(level, options.format, options.quality, progress, work.stopToken());
        if (!blocks)
            return fail(blocks.error());
        texture.surfaces.emplace_back(*std::move(blocks));
        donePixels += pixels;
    }
    return texture;
}

ExitCode run(const Options& options) {
    const Result<const CodecRow*> writer = writerFor(options.out);
    if (!writer)
        return complain(writer.error(), wrongCall);
    Result<TextureImage> file = readTexture(options.in);
    if (!file)
        return complain(file.error());
    LongWork work("texshot: compressing");
    const Result<TextureImage> texture = compress(uprightImage(*std::move(file)), options, work);
    if (!texture && texture.error().code == ErrorCode::Cancelled)
        return complain({ErrorCode::Cancelled, "interrupted; nothing was written", {}}, interrupted);
    if (!texture)
        return complain({texture.error().code, texture.error().message, options.in});
    if (const auto written = writeTexture(options.out, *texture); !written)
        return complain(written.error());
    return success;
}

} // namespace

void addCompress(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("compress", "Compress a picture into a DDS file of S3TC or RGTC blocks.");
    auto options = std::make_shared<Options>();
    command->add_option("IN", options->in, "The picture: any format that Texplorer reads.")->required();
    command->add_option("OUT", options->out, "The DDS file to write.")->required();
    command->add_option("--format", options->format, "dxt1, dxt1a (1-bit alpha), dxt3, dxt5, bc4 or bc5.")
        ->required()
        ->transform(CLI::CheckedTransformer(formats).description(""));
    command
        ->add_option("--quality", options->quality,
                     "fast, normal or best: from tens of megatexels a second to half a one.")
        ->transform(CLI::CheckedTransformer(qualities()).description(""));
    command
        ->add_option("--mips", options->mips, "box: the whole chain by a box filter (the default), or none.")
        ->transform(CLI::CheckedTransformer(std::map<std::string, bool>{{"box", true}, {"none", false}})
                        .description(""));
    command->callback([&action, options] { action = [options] { return run(*options); }; });
}

} // namespace texplorer::screenshot
