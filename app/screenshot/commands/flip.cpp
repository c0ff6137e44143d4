#include "app/screenshot/arguments/image_files.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/command.h"
#include "app/screenshot/output/long_work.h"
#include "core/s3tc/texture_flip.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

constexpr ImageFormats flipFormats{}; // that of the file which is turned

struct FlipOptions {
    ImageFiles files;
    bool horizontal = false;
    bool halfTurn = false;
    bool lossy = false;

    [[nodiscard]] FlipAxis axis() const {
        return halfTurn ? FlipAxis::Both : horizontal ? FlipAxis::Horizontal : FlipAxis::Vertical;
    }
};

Result<MadeImage> flipFile(const std::string& in, const FlipOptions& options) {
    Result<TextureImage> texture = readTexture(in);
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
                    inputName(in));
    }
    return MadeImage{*std::move(texture)};
}

} // namespace

void addFlip(CommandLine& line) {
    Command& command = line.command(
        "flip", "Turn a texture upside down, every mip level, face and slice; compressed blocks without "
                "decompressing them.");
    auto options = std::make_shared<FlipOptions>();
    const Option& out =
        addImageFiles(command, options->files, flipFormats, "The texture: any format that Texplorer reads",
                      "Print a line for each texture: what became of what.");
    command.usage({"IN OUT", "IN... -o DIR", "IN... --in-place"});
    command.flag("--in-place", options->files.inPlace,
                 "Write each texture in its own place: without this no output takes the place of an input.",
                 {.excludes = &out});
    const Option& horizontal = command.flag("--horizontal", options->horizontal, "Left to right instead.");
    command.flag("--half-turn", options->halfTurn, "By 180 degrees instead.", {.excludes = &horizontal});
    command.flag(
        "--lossy", options->lossy,
        fmt::format(
            "Decompress and compress again the levels that can't be turned around without loss: those whose "
            "extent is not {}.",
            losslessExtents));
    command.onCall([options] {
        return makeImages(options->files, flipFormats,
                          [&](const std::string& in) { return flipFile(in, *options); });
    });
}

} // namespace texplorer::screenshot
