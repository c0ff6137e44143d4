#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/command.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/output.h"
#include "core/s3tc/texture_flip.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

struct FlipOptions {
    std::string in;
    std::string out;
    bool horizontal = false;
    bool halfTurn = false;
    bool lossy = false;

    [[nodiscard]] FlipAxis axis() const {
        return halfTurn ? FlipAxis::Both : horizontal ? FlipAxis::Horizontal : FlipAxis::Vertical;
    }
};

Result<void> flipFile(const FlipOptions& options, const ImageOutput& output) {
    Result<TextureImage> texture = readTexture(options.in);
    if (!texture)
        return fail(texture.error());
    LongWork work("texshot: turning around");
    const Result<void> turned = flip(*texture, {.axis = options.axis(),
                                                .lossy = options.lossy,
                                                .progress = [&work](float done) { work.report(done); },
                                                .stop = work.stopToken()});
    work.finish();
    if (work.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled, "turning around was stopped");
    if (!turned) {
        const bool wouldLose = turned.error().code == ErrorCode::Unsupported && !options.lossy;
        return fail(turned.error().code,
                    turned.error().message +
                        (wouldLose ? "; --lossy decompresses it and compresses it again" : ""),
                    options.in);
    }
    return output.write(*texture);
}

/// What a pipe gets: the format of the file that is turned, where that is written.
std::string_view formatFor(const std::string& in) {
    const CodecRow* format = codecForExtension(in);
    return format != nullptr && format->encode ? format->name : "PNG";
}

ExitCode run(const FlipOptions& options) {
    const auto output = openImageOutput(options.out, formatFor(options.in));
    if (!output)
        return output.error();
    const auto done = flipFile(options, *output);
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
    auto options = std::make_shared<FlipOptions>();
    command.option("IN", options->in, "The texture: any format that Texplorer reads.", {.required = true});
    command.option(
        "OUT", options->out,
        fmt::format(
            "The file to write, its format by its extension: {}; - for standard output, in the format of IN.",
            writtenExtensions(" or ")),
        {.required = true});
    const Option& horizontal = command.flag("--horizontal", options->horizontal, "Left to right instead.");
    command.flag("--half-turn", options->halfTurn, "By 180 degrees instead.", {.excludes = &horizontal});
    command.flag(
        "--lossy", options->lossy,
        fmt::format(
            "Decompress and compress again the levels that can't be turned around without loss: those whose "
            "extent is not {}.",
            losslessExtents));
    command.onCall([options] { return run(*options); });
}

} // namespace texplorer::screenshot
