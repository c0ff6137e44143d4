#include "core/s3tc/flip.h"

#include "app/screenshot/command.h"
#include "app/screenshot/texture_io.h"

namespace texplorer::screenshot {
namespace {

struct Options {
    std::string in;
    std::string out;
    bool horizontal = false;
    bool halfTurn = false;
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

Result<void> turn(Surface& surface, const Options& options) {
    if (Image* image = std::get_if<Image>(&surface)) {
        if (!options.horizontal)
            flipVertically(*image);
        if (options.horizontal || options.halfTurn)
            mirror(*image);
        return {};
    }
    BlockImage& blocks = std::get<BlockImage>(surface);
    if (options.halfTurn)
        return rotateHalfTurn(blocks);
    return options.horizontal ? flipHorizontally(blocks) : flipVertically(blocks);
}

Result<void> flip(const Options& options) {
    if (const auto writer = writerFor(options.out); !writer)
        return fail(writer.error());
    Result<TextureImage> decoded = readTexture(options.in);
    if (!decoded)
        return fail(decoded.error());
    TextureImage& texture = *decoded;
    for (std::size_t i = 0; i < texture.surfaces.size(); ++i) {
        if (const auto turned = turn(texture.surfaces[i], options); !turned) {
            const std::size_t level = i % static_cast<std::size_t>(texture.levels);
            return fail(turned.error().code, "level " + std::to_string(level) + ": " + turned.error().message,
                        options.in);
        }
    }
    return writeTexture(options.out, texture);
}

} // namespace

void addFlip(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand(
        "flip", "Turn a texture upside down, every mip level, face and slice; compressed blocks without "
                "decompressing them.");
    auto options = std::make_shared<Options>();
    command->add_option("IN", options->in, "The texture: any format that Texplorer reads.")->required();
    command->add_option("OUT", options->out, "The file to write, its format by its extension.")->required();
    CLI::Option* horizontal =
        command->add_flag("--horizontal", options->horizontal, "Left to right instead.");
    command->add_flag("--half-turn", options->halfTurn, "By 180 degrees instead.")->excludes(horizontal);
    command->callback([&action, options] {
        action = [options] {
            if (const auto done = flip(*options); !done)
                return complain(done.error());
            return success;
        };
    });
}

} // namespace texplorer::screenshot
