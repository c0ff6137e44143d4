#include "core/scene/image_source.h"

#include "core/codec/image_file.h"
#include "core/image/pattern.h"

#include <array>
#include <mutex>
#include <optional>

namespace texplorer {

namespace {

// Patterns are constants that are worked out when they are first asked for; every source shares them.
std::shared_ptr<const Image> sharedPattern(Pattern pattern) {
    struct Constant {
        std::once_flag drawn;
        std::shared_ptr<const Image> image;
    };
    static std::array<Constant, patternRows.size()> constants;

    const auto index = static_cast<std::size_t>(pattern);
    if (index >= constants.size())
        return nullptr;
    Constant& constant = constants[index];
    std::call_once(constant.drawn,
                   [&] { constant.image = std::make_shared<const Image>(drawPattern(pattern)); });
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
        if (texture.file.empty()) {
            first =
                first.value_or(Error{ErrorCode::NotFound, "the texture wants an image file, but names none",
                                     "textures[" + std::to_string(i) + "].file"});
            continue;
        }
        Result<ImageFile> file = readImageFile(directory_ / texture.file);
        if (file)
            put(texture.file, std::move(file->image));
        else
            first = first.value_or(file.error());
    }
    if (first)
        return fail(*std::move(first));
    return {};
}

std::shared_ptr<const Image> ImageSource::find(const Texture& texture) const {
    if (texture.source == SourceKind::Pattern)
        return sharedPattern(texture.pattern);
    const auto found = files_.find(texture.file);
    return found == files_.end() ? nullptr : found->second;
}

} // namespace texplorer
