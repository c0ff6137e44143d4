#include "core/scene/image_source.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "core/image/pattern.h"

#include <array>
#include <mutex>
#include <optional>

namespace texplorer {

namespace {

/// A picture of ours: there is no file whose first row could be the top one.
TextureImage madeHere(Image image) {
    TextureImage texture = textureOf(std::move(image), {});
    texture.fileTopFirst = false;
    return texture;
}

Result<TextureImage> readTexture(const std::filesystem::path& path) {
    const Result<Bytes> file = readFile(path);
    if (!file)
        return fail(file.error());
    Result<TextureImage> texture = decodeTexture(*file);
    if (!texture)
        return fail(texture.error().code, texture.error().message, path.string());
    return texture;
}

// Patterns are constants that are worked out when they are first asked for; every source shares them.
std::shared_ptr<const TextureImage> sharedPattern(Pattern pattern) {
    struct Constant {
        std::once_flag drawn;
        std::shared_ptr<const TextureImage> image;
    };
    static std::array<Constant, patternRows.size()> constants;

    const auto index = static_cast<std::size_t>(pattern);
    if (index >= constants.size())
        return nullptr;
    Constant& constant = constants[index];
    std::call_once(constant.drawn, [&] {
        constant.image = std::make_shared<const TextureImage>(madeHere(drawPattern(pattern)));
    });
    return constant.image;
}

} // namespace

ImageSource::ImageSource(std::filesystem::path directory)
    : directory_(std::move(directory)) {}

Result<void> ImageSource::load(const Scene& scene) {
    std::optional<Error> first;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        if (texture.source != SourceKind::File || files_.contains(texture.file))
            continue;
        const std::string path = "textures[" + std::to_string(i) + "].file";
        if (texture.file.empty()) {
            first = first.value_or(
                Error{ErrorCode::NotFound, "the texture wants an image file, but names none", path});
            continue;
        }
        Result<TextureImage> image = readTexture(directory_ / texture.file);
        if (image)
            put(texture.file, *std::move(image));
        else
            first = first.value_or(Error{image.error().code, describe(image.error()), path});
    }
    if (first)
        return fail(*std::move(first));
    return {};
}

void ImageSource::put(const std::string& file, Image image) {
    put(file, madeHere(std::move(image)));
}

std::shared_ptr<const TextureImage> ImageSource::find(const Texture& texture) const {
    if (texture.source == SourceKind::Pattern)
        return sharedPattern(texture.pattern);
    const auto found = files_.find(texture.file);
    return found == files_.end() ? nullptr : found->second;
}

} // namespace texplorer
