#include "app/screenshot/command.h"
#include "app/screenshot/texture_io.h"

namespace texplorer::screenshot {

void addConvert(CLI::App& app, Action& action) {
    struct Options {
        std::string in;
        std::string out;
        WriteOptions write;
    };
    CLI::App* command =
        app.add_subcommand("convert", "Write an image in another format, chosen by the extension of OUT.");
    auto options = std::make_shared<Options>();
    command->add_option("IN", options->in, "The image: any format that Texplorer reads.")->required();
    command
        ->add_option(
            "OUT", options->out,
            "The file to write. Formats of one picture take the base level, decompressed; DDS takes all.")
        ->required();
    command->add_flag("--rle", options->write.runLengthCoded, "TGA: run-length coded.");
    command->add_flag("--small", options->write.small, "PNG: smaller rather than faster.");
    command->callback([&action, options] {
        action = [options] {
            if (const auto writer = writerFor(options->out); !writer)
                return complain(writer.error(), wrongCall);
            const Result<TextureImage> file = readTexture(options->in);
            if (!file)
                return complain(file.error());
            if (const auto written = writeTexture(options->out, *file, options->write); !written)
                return complain(written.error());
            return success;
        };
    });
}

} // namespace texplorer::screenshot
