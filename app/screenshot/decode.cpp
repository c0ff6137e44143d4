#include "app/screenshot/command.h"
#include "core/codec/image_file.h"
#include "core/codec/png.h"
#include "core/image/mipmaps.h"

namespace texplorer::screenshot {
namespace {

struct Options {
    std::string in;
    std::string out;
    int level = 0;
};

Result<Bytes> decodeToPng(const Options& options) {
    Result<ImageFile> file = readImageFile(options.in);
    if (!file)
        return fail(file.error());
    Image& image = file->image;
    if (options.level == 0)
        return encodePng(image);

    const int levels = mipLevelCount(image.width, image.height, image.depth);
    if (options.level >= levels) {
        return fail(ErrorCode::OutOfRange,
                    "there is no level " + std::to_string(options.level) + ": " +
                        std::to_string(image.width) + " x " + std::to_string(image.height) +
                        " texels give levels 0 to " + std::to_string(levels - 1),
                    options.in);
    }
    const MipChain chain = buildMipChain(std::move(image));
    return encodePng(chain[static_cast<std::size_t>(options.level)]);
}

} // namespace

void addDecode(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("decode", "Turn an image file into a PNG.");
    auto options = std::make_shared<Options>();
    command->add_option("IN", options->in, "The image: any format that Texplorer reads.")->required();
    command->add_option("OUT", options->out, "The PNG to write; - for standard output.")->required();
    command
        ->add_option(
            "--level", options->level,
            "Which mip level, 0 the base. A file that holds only the base gets its levels from a box filter.")
        ->check(CLI::Range(0, 30));
    command->callback([&action, options] {
        action = [options] {
            const Result<Bytes> png = decodeToPng(*options);
            if (!png)
                return complain(png.error());
            if (const auto written = writeOutput(options->out, *png); !written)
                return complain(written.error());
            return success;
        };
    });
}

} // namespace texplorer::screenshot
