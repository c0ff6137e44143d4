#include "app/screenshot/command.h"
#include "core/base/file_io.h"
#include "core/codec/image_file.h"
#include "core/image/mipmaps.h"

#include <nlohmann/json.hpp>

namespace texplorer::screenshot {
namespace {

std::string asText(const std::string& path, const ImageFile& file) {
    const Image& image = file.image;
    std::string text;
    const auto line = [&](std::string_view name, const std::string& value) {
        text.append(name).append(14 - name.size(), ' ').append(value).append("\n");
    };
    line("file", path);
    line("format", std::string(file.format));
    line("size", std::to_string(image.width) + " x " + std::to_string(image.height) + " texels");
    line("pixels", std::string(rowOf(image.format).name));
    line("file bytes", std::to_string(file.fileBytes));
    line("pixel bytes", std::to_string(image.pixels.size()));
    line("full chain", std::to_string(mipLevelCount(image.width, image.height, image.depth)) + " mip levels");
    return text;
}

std::string asJson(const std::string& path, const ImageFile& file) {
    const Image& image = file.image;
    const nlohmann::ordered_json json = {
        {"file", path},
        {"format", file.format},
        {"width", image.width},
        {"height", image.height},
        {"depth", image.depth},
        {"pixelFormat", rowOf(image.format).name},
        {"fileBytes", file.fileBytes},
        {"pixelBytes", image.pixels.size()},
        {"mipLevels", mipLevelCount(image.width, image.height, image.depth)},
    };
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace

void addInfo(CLI::App& app, Action& action) {
    struct Options {
        std::string in;
        bool json = false;
    };
    CLI::App* command = app.add_subcommand("info", "What an image file holds.");
    auto options = std::make_shared<Options>();
    command->add_option("IN", options->in, "The image: any format that Texplorer reads.")->required();
    command->add_flag("--json", options->json, "As JSON, for programs.");
    command->callback([&action, options] {
        action = [options] {
            const Result<ImageFile> file = readImageFile(options->in);
            if (!file)
                return complain(file.error());
            const std::string text = options->json ? asJson(options->in, *file) : asText(options->in, *file);
            if (const auto written = writeOutput("-", viewBytes(text)); !written)
                return complain(written.error());
            return success;
        };
    });
}

} // namespace texplorer::screenshot
