#include "app/screenshot/arguments/image_files.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/commands/all_commands.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

constexpr ImageFormats convertFormats{
    .only = {},
    .start = "PNG",
    .named = true,
    .lossy =
        "Also write files that OUT can't hold completely: layers, faces, slices and mip levels in a format "
        "of one picture, or more than 8 bits a component. Else these are refused; losses are always "
        "reported."};

struct ConvertOptions {
    ImageFiles files;
    WriteOptions write;
};

void noteOptions(const CodecRow& written, const WriteOptions& options) {
    for (const auto& [option, given, format] :
         {std::tuple{"--rle", options.runLengthCoded, "TGA"}, std::tuple{"--small", options.small, "PNG"}})
        if (given && written.name != format)
            noteUnused(option, fmt::format("it applies to {} files only, OUT is {}", format, written.name));
}

} // namespace

void addConvert(CommandLine& line) {
    Command& command = line.command(
        "convert",
        "Write images in another format. DDS can hold complete textures. For formats of one picture, "
        "--lossy keeps level, face, slice and layer 0.");
    auto options = std::make_shared<ConvertOptions>();
    addImageFiles(command, options->files, convertFormats, "The image: any format that Texplorer reads",
                  "Print a line for each image with its input and output.");
    command.flag("--rle", options->write.runLengthCoded, "TGA: run-length coded.");
    command.flag("--small", options->write.small, "PNG: smaller rather than faster.");
    command.onCall([options] {
        return makeImages(
            options->files, convertFormats,
            [&](const std::string& in) {
                return readTexture(in).map([&](TextureImage&& image) {
                    return MadeImage{std::move(image), options->write};
                });
            },
            [&](const CodecRow& written) { noteOptions(written, options->write); });
    });
}

} // namespace texplorer::screenshot
