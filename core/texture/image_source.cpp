#include "core/texture/image_source.h"

#include "core/base/file_fingerprint.h"
#include "core/base/file_io.h"
#include "core/image/patterns/pattern.h"

#include <fmt/core.h>

#include <algorithm>
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

using SharedImage = std::shared_ptr<const TextureImage>;

Result<SharedImage> readImage(const std::filesystem::path& path, std::size_t left, Decoding decoding) {
    const Result<Bytes> file = readFile(path);
    if (!file)
        return fail(file.error());
    Result<TextureImage> texture = decodeWithin(*file, left, decoding);
    if (!texture)
        return fail(texture.error().code, texture.error().message, path.string());
    return std::make_shared<const TextureImage>(std::move(*texture));
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

std::vector<std::optional<Error>> ImageSource::loadAll(const Scene& scene, std::size_t budget,
                                                       Decoding decoding) {
    std::vector<std::optional<Error>> errors(scene.textures.size());
    std::map<FileFingerprint, Result<SharedImage>> read;
    std::size_t used = bytesOf(filesOf(scene));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const Texture& texture = scene.textures[i];
        if (texture.source != SourceKind::File || files_.contains(texture.file))
            continue;
        const std::string where = fmt::format("textures[{}].file", i);
        if (texture.file.empty()) {
            errors[i] = Error{ErrorCode::NotFound, "the texture wants an image file, but names none", where};
            continue;
        }
        const std::filesystem::path path = directory_ / texture.file;
        const std::optional<FileFingerprint> same = fingerprintOf(path);
        const auto known = same ? read.find(*same) : read.end();
        const Result<SharedImage> image =
            known != read.end() ? known->second : readImage(path, budget - std::min(budget, used), decoding);
        if (image) {
            used += known != read.end() ? 0 : byteCount(**image);
            put(texture.file, *image);
        } else {
            errors[i] = Error{image.error().code, describe(image.error()), where};
        }
        if (same)
            read.emplace(*same, image);
    }
    return errors;
}

Result<void> ImageSource::load(const Scene& scene, std::size_t budget) {
    for (std::optional<Error>& error : loadAll(scene, budget, Decoding::Pixels))
        if (error)
            return fail(*std::move(error));
    return {};
}

std::vector<std::optional<Error>> ImageSource::loadOutlines(const Scene& scene, std::size_t budget) {
    return loadAll(scene, budget, Decoding::Outline);
}

std::size_t ImageSource::bytesOf(const std::set<std::string>& files) const {
    std::set<SharedImage> images;
    for (const std::string& file : files)
        if (const auto found = files_.find(file); found != files_.end())
            images.insert(found->second);
    std::size_t bytes = 0;
    for (const SharedImage& image : images)
        bytes += byteCount(*image);
    return bytes;
}

std::set<std::string> filesOf(const Scene& scene) {
    std::set<std::string> files;
    for (const Texture& texture : scene.textures)
        if (texture.source == SourceKind::File)
            files.insert(texture.file);
    return files;
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
