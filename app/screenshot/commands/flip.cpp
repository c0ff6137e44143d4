#include "app/screenshot/arguments/image_files.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/long_work.h"
#include "texplorer/s3tc/texture_flip.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

/// The format is that of the file which is turned.
ImageFormats flipFormats() {
    static const std::string lossy = fmt::format(
        "Also flip with losses: levels of blocks whose size is not {} are decompressed and compressed "
        "again, and parts that OUT can't hold are dropped, as in convert. Else such a file is refused; "
        "losses are always reported.",
        losslessExtents);
    ImageFormats turned;
    turned.lossy = lossy;
    return turned;
}

struct FlipOptions {
    ImageFiles files;
    bool horizontal = false;
    bool halfTurn = false;

    [[nodiscard]] FlipAxis axis() const {
        return halfTurn ? FlipAxis::Both : horizontal ? FlipAxis::Horizontal : FlipAxis::Vertical;
    }
};

Result<MadeImage> flipFile(const std::string& in, const FlipOptions& options) {
    Result<TextureImage> texture = readTexture(in);
    const bool lossy = options.files.lossy;
    if (!texture)
        return fail(texture.error());
    LongWork work("texshot: flipping");
    const Result<void> turned = flip(*texture, {.axis = options.axis(),
                                                .lossy = lossy,
                                                .progress = [&work](float done) { work.report(done); },
                                                .stop = work.stopToken()});
    work.finish();
    if (work.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled, "flipping was stopped");
    if (!turned) {
        const bool wouldLose = turned.error().code == ErrorCode::Unsupported && !lossy;
        return fail(turned.error().code,
                    wouldLose ? Sentence("{0}; --lossy decompresses it and compresses it again",
                                         turned.error().message)
                              : turned.error().message,
                    inFile(inputName(in)));
    }
    return MadeImage{*std::move(texture)};
}

} // namespace

void addFlip(CommandLine& line) {
    Command& command = line.command(
        "flip",
        "Flip a texture upside down, with all mip levels, faces, slices and layers. Compressed blocks are "
        "not decompressed.");
    auto options = std::make_shared<FlipOptions>();
    const Option* out =
        addImageFiles(command, options->files, flipFormats(), "The texture: any format that Texplorer reads",
                      "Print a line for each texture with its input and output.");
    command.usage({"IN OUT", "IN... -o DIR", "IN... --in-place"});
    command.flag("--in-place", options->files.inPlace,
                 "Overwrite each input. Without this option no output may overwrite an input.",
                 {.excludes = out});
    const Option& horizontal = command.flag("--horizontal", options->horizontal, "Left to right instead.");
    command.flag("--half-turn", options->halfTurn, "By 180 degrees instead.", {.excludes = &horizontal});
    command.onCall([options] {
        return makeImages(options->files, flipFormats(),
                          [&](const std::string& in) { return flipFile(in, *options); });
    });
}

} // namespace texplorer::screenshot
