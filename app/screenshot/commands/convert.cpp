#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/texture_input.h"
#include "app/screenshot/command.h"
#include "app/screenshot/output/output.h"

#include <fmt/core.h>

namespace texplorer::screenshot {

namespace {

struct ConvertOptions {
    std::string in;
    std::string out;
    WriteOptions write;
};

ExitCode convert(const ConvertOptions& options) {
    const auto output = openImageOutput(options.out, "PNG");
    if (!output)
        return output.error();
    for (const auto& [option, given, format] : {std::tuple{"--rle", options.write.runLengthCoded, "TGA"},
                                                std::tuple{"--small", options.write.small, "PNG"}})
        if (given && output->format->name != format)
            return refuseUnused(option,
                                fmt::format("it is for {} files, OUT is {}", format, output->format->name));
    const Result<TextureImage> file = readTexture(options.in);
    if (!file)
        return complain(file.error());
    if (const auto written = output->write(*file, options.write); !written)
        return complain(written.error());
    return success;
}

} // namespace

void addConvert(CommandLine& line) {
    Command& command =
        line.command("convert", "Write an image in another format, chosen by the extension of OUT.");
    auto options = std::make_shared<ConvertOptions>();
    command.option("IN", options->in, "The image: any format that Texplorer reads.", {.required = true});
    command.option(
        "OUT", options->out,
        fmt::format(
            "The file to write, its format by its extension: {}; - for standard output, as PNG. Formats of "
            "one picture take the base level, decompressed; DDS takes all.",
            writtenExtensions(" or ")),
        {.required = true});
    command.flag("--rle", options->write.runLengthCoded, "TGA: run-length coded.");
    command.flag("--small", options->write.small, "PNG: smaller rather than faster.");
    command.onCall([options] { return convert(*options); });
}

} // namespace texplorer::screenshot
