#include "core/s3tc/flip.h"

#include "app/screenshot/command.h"
#include "app/screenshot/interrupts.h"
#include "app/screenshot/long_work.h"
#include "app/screenshot/output.h"
#include "app/screenshot/texture_input.h"

namespace texplorer::screenshot {
namespace {

struct Options {
    std::string in;
    std::string out;
    bool horizontal = false;
    bool halfTurn = false;
    bool lossy = false;

    [[nodiscard]] FlipAxis axis() const {
        return halfTurn ? FlipAxis::Both : horizontal ? FlipAxis::Horizontal : FlipAxis::Vertical;
    }
};

void mirror(Image& image) {
    const std::size_t pixel = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t row = 0; row < image.pixels.size(); row += image.rowBytes()) {
        std::byte* left = image.pixels.data() + row;
        std::byte* right = left + image.rowBytes() - pixel;
        for (; left < right; left += pixel, right -= pixel)
            std::swap_ranges(left, left + pixel, right);
    }
}

Result<void> turnBlocks(BlockImage& blocks, FlipAxis axis) {
    switch (axis) {
    case FlipAxis::Vertical:
        return flipVertically(blocks);
    case FlipAxis::Horizontal:
        return flipHorizontally(blocks);
    case FlipAxis::Both:
        break;
    }
    return rotateHalfTurn(blocks);
}

Result<void> turn(Surface& surface, const Options& options, LongWork& work) {
    if (Image* image = std::get_if<Image>(&surface)) {
        if (!options.horizontal)
            flipVertically(*image);
        if (options.horizontal || options.halfTurn)
            mirror(*image);
        return {};
    }
    BlockImage& blocks = std::get<BlockImage>(surface);
    const Result<void> turned = turnBlocks(blocks, options.axis());
    if (turned || turned.error().code != ErrorCode::Unsupported)
        return turned;
    if (!options.lossy)
        return fail(ErrorCode::Unsupported,
                    turned.error().message + "; --lossy decompresses it and compresses it again");
    Result<BlockImage> again = decodeFlipEncode(
        blocks, options.axis(), EncodeQuality::Best, [&work](float done) { work.report(done); },
        work.stopToken());
    if (!again)
        return fail(again.error());
    blocks = *std::move(again);
    return {};
}

Result<void> flip(const Options& options, const ImageOutput& output) {
    Result<TextureImage> decoded = readTexture(options.in);
    if (!decoded)
        return fail(decoded.error());
    TextureImage& texture = *decoded;
    LongWork work("texshot: turning around");
    for (std::size_t i = 0; i < texture.surfaces.size(); ++i) {
        if (const auto turned = turn(texture.surfaces[i], options, work); !turned) {
            const std::size_t level = i % static_cast<std::size_t>(texture.levels);
            return fail(turned.error().code, "level " + std::to_string(level) + ": " + turned.error().message,
                        options.in);
        }
    }
    work.finish();
    if (work.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled, "turning around was stopped");
    return output.write(texture);
}

/// What a pipe gets: the format of the file that is turned, where that is written.
std::string_view formatFor(const std::string& in) {
    const CodecRow* format = codecForExtension(in);
    return format != nullptr && format->encode ? format->name : "PNG";
}

ExitCode run(const Options& options) {
    const auto output = openImageOutput(options.out, formatFor(options.in));
    if (!output)
        return output.error();
    const auto done = flip(options, *output);
    if (!done && done.error().code == ErrorCode::Cancelled)
        return complainInterrupted();
    if (!done)
        return complain(done.error());
    return success;
}

} // namespace

void addFlip(CommandLine& line) {
    Command& command = line.command(
        "flip", "Turn a texture upside down, every mip level, face and slice; compressed blocks without "
                "decompressing them.");
    auto options = std::make_shared<Options>();
    command.option("IN", options->in, "The texture: any format that Texplorer reads.", {.required = true});
    command.option("OUT", options->out,
                   "The file to write, its format by its extension: " + writtenExtensions() +
                       "; - for standard output, in the format of IN.",
                   {.required = true});
    const Option& horizontal = command.flag("--horizontal", options->horizontal, "Left to right instead.");
    command.flag("--half-turn", options->halfTurn, "By 180 degrees instead.", {.excludes = &horizontal});
    command.flag("--lossy", options->lossy,
                 "Decompress and compress again the levels that can't be turned around without loss: "
                 "those whose extent is not " +
                     std::string(losslessExtents) + ".");
    command.onCall([options] { return run(*options); });
}

} // namespace texplorer::screenshot
